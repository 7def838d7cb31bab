#pragma once

#include "base/chart.hpp"
#include "view/axis.hpp"
#include "view/drawing.hpp"

namespace fingerpad {

/// Where the parts of a chart stand in a drawing. Widths of texts are measured.
struct ChartLayout {
  struct Panel {
    Box frame;             ///< whole pixels
    Axis x, y;             ///< over all that the panel holds
    bool foot = true;      ///< the x axis has its labels here
    double y_label_x = 0;  ///< middle of the line that the y label stands on
    double title_y = 0;  ///< baseline of the title, or middle of the legend's last line above a stacked panel
    int legend_rows = 1;  ///< lines that the legend above a stacked panel has room for
  };
  double em = 12;  ///< size of texts [px]
  Box page;        ///< the whole of it
  std::vector<Panel> panels;
  Box strip;          ///< of the band; empty where there is none
  Vec2 legend{0, 0};  ///< of a page: left end, middle of the first line
  int columns = 1, rows = 1;
  double gutter_x = 0, gutter_y = 0;  ///< between frames
};

/// A stacked chart in a box.
/// @param least_left  where the frames begin at the earliest
ChartLayout stacked_layout(const Chart& chart, const Box& box, double em, double least_left = 0);

/// Size of the texts in a chart that is written to a file, a page or stacked panels [px].
inline constexpr double chart_page_em = 16;
/// Size of a chart's title, in sizes of its other texts.
inline constexpr double chart_title_ems = 1.35;

/// A page of panels of one size, as large as it takes: `page` says how large.
ChartLayout page_layout(const Chart& chart);

/// How many marks an axis of this length has room for.
int marks_along_x(double length_px, double em);
int marks_along_y(double length_px, double em);

/// The y label, or the short one where that does not fit along the frame.
const std::string& fitting_y_label(const ChartPanel& panel, double height_px, double em);

/// How wide the legend beside a page of panels is; 0 without one.
double legend_width(const Chart& chart, double em);

/// From one line of a stacked panel's legend to the next, in sizes of the texts.
inline constexpr double legend_line_ems = 1.4;

/// In how many lines, at most chart.legend_rows, the legend above each stacked panel of this width has its
/// entries whole: the first one's, and below it as many above each.
std::vector<int> legend_rows(const Chart& chart, double width_px, double em);

/// What the lines of all legends take that have more than one, in a stacked chart in a box of this width
/// [px].
double further_legend_lines_px(const Chart& chart, double box_width_px, double em);

/// Titles, notes and legends: all but what stands in the frames and along them.
Drawing chart_words(const Chart& chart, const ChartLayout& layout);

}  // namespace fingerpad
