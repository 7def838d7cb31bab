#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/colour.hpp"

namespace fingerpad {

// What a chart shows, as plain data. Studies, plots and windows fill it in; view/ draws it.

enum class Dash { none, solid, dashed, dotted, dash_dot };  ///< none: marks alone
enum class Marker { none, disc, square, triangle, diamond, ring, cross };

struct CurveStyle {
  int colour = palette::blue;  ///< an index into the palette
  Dash dash = Dash::solid;
  Marker marker = Marker::disc;
  double weight = 1;  ///< of line and marker
};

/// One curve or set of points; a y that is not finite leaves a gap.
struct ChartCurve {
  std::string name;  ///< in the legend, which shows each name once; empty: none
  CurveStyle style;
  std::vector<double> x, y;
};

/// A dashed level across a panel.
struct ChartLevel {
  std::string name;
  double y = 0;
  int colour = palette::grey;  ///< an index into the palette
};

struct ChartPanel {
  std::string title;
  std::string x_label, y_label;  ///< with units in brackets
  bool log_x = false, log_y = false;
  std::vector<ChartCurve> curves;
  /// Points that no other beats in both x and y (smaller is better), by x: drawn as a line behind.
  std::vector<std::pair<double, double>> pareto_front = {};
  bool equal_scales = false;       ///< a unit is as long along x as along y; for linear axes
  std::string short_y_label = {};  ///< where the other does not fit; empty: none
  std::vector<ChartLevel> levels = {};
  bool y_from_zero = false;  ///< the y axis holds zero
  double least_y_span = 0;   ///< a linear y axis spans at least this: less would blow noise up to a signal
};

/// Colours behind the panels over spans of x, such as the phases of a touch.
struct ChartBand {
  struct Key {
    std::string name;
    Colour colour;
  };
  std::string title;
  std::vector<Key> keys;
  std::vector<double> x;            ///< increasing
  std::vector<std::size_t> key_at;  ///< one for each x: index into keys; it holds up to the next x
};

/// A page of panels.
struct Chart {
  std::string name;  ///< of the file, without its ending
  std::string title;
  std::vector<std::string> notes;  ///< lines below the title
  int columns = 1;
  std::vector<ChartPanel> panels;  ///< row by row
  /// The panels stand over one another and share one x axis, which ends with its values; each has a legend of
  /// its own above it. Otherwise each has its own axes and one legend stands beside them all.
  bool stacked = false;
  int legend_rows = 1;  ///< of a stacked chart: so many lines at most take the entries of a panel's legend
  std::optional<ChartBand> band = {};  ///< of a stacked chart: a strip above the panels, with its legend
};

}  // namespace fingerpad
