#pragma once

#include <vector>

#include "base/chart.hpp"
#include "view/chart_layout.hpp"
#include "view/drawing.hpp"

namespace fingerpad {

/// Where the panels of a drawn chart lie, to put a cursor in and to read the mouse.
struct ChartPlace {
  std::vector<Box> panels;  ///< from the top
  double x_min = 0, x_max = 1;
  double x_at(double drawing_x) const;
  double drawing_x_at(double x) const;
};

/// Draws a stacked chart into a box. Needs no screen.
/// @param text_size   of labels [px]
/// @param least_left  where the frames begin at the earliest, to line up with those of another chart
ChartPlace draw_chart(Drawing& drawing, const Chart& chart, const Box& box, double text_size,
                      double least_left = 0);

/// A drawing that fills a page of its own.
struct ChartPage {
  Drawing drawing;
  int width = 0, height = 0;  ///< [px]
};

/// Draws a chart's page of panels. Needs no screen.
ChartPage chart_page(const Chart& chart);

}  // namespace fingerpad
