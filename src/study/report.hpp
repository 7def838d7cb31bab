#pragma once

#include <string>
#include <variant>
#include <vector>

namespace fingerpad {

/// A table that a study writes as CSV: names with units, rows of words and numbers (nan where there is none).
struct StudyTable {
  using Cell = std::variant<std::string, double>;
  std::string name;  ///< of the file, without .csv
  std::vector<std::string> columns;
  std::vector<std::vector<Cell>> rows;

  std::string csv() const;
};

enum class SeriesDash { none, solid, dashed, dotted, dash_dot };  ///< none: points alone
enum class SeriesMarker { none, disc, square, triangle, diamond, ring, cross };

/// How a series is drawn; colours count through the eight of Okabe & Ito.
struct SeriesStyle {
  int colour = 0;
  SeriesDash dash = SeriesDash::solid;
  SeriesMarker marker = SeriesMarker::disc;
  double weight = 1;  ///< of line and marker
};

/// One style a law, on every chart: 14 laws, told apart by colour, dash and marker together.
SeriesStyle law_style(const std::string& law);

/// One curve or set of points; a y that is not finite leaves a gap.
struct StudySeries {
  std::string name;  ///< in the legend, which shows each name once; empty: none
  SeriesStyle style;
  std::vector<double> x, y;
};

struct StudyPanel {
  std::string title;
  std::string x_label, y_label;  ///< with units
  bool log_x = false, log_y = false;
  std::vector<StudySeries> series;
  /// Points that no other beats in both x and y (smaller is better), by x: drawn as a line behind.
  std::vector<std::pair<double, double>> pareto_front;
  bool equal_scales = false;  ///< a unit is as long along x as along y; for linear axes
};

/// A page of panels, all with one legend.
struct StudyChart {
  std::string name;  ///< of the file, without its ending
  std::string title;
  std::vector<std::string> notes;  ///< lines below the title
  int columns = 1;
  std::vector<StudyPanel> panels;  ///< row by row
};

/// What a study found. Tables and charts whose name ends in "_measured" hold times of this machine; all
/// others are the same bytes at every run.
struct StudyReport {
  std::vector<StudyTable> tables;
  std::vector<StudyChart> charts;
};

/// The points of `points` that no other beats in both numbers, by the first. Points that are not finite or
/// not positive are passed over.
std::vector<std::pair<double, double>> pareto_front(std::vector<std::pair<double, double>> points);

}  // namespace fingerpad
