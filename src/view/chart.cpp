#include "view/chart.hpp"

#include <algorithm>
#include <cmath>

#include "view/chart_board_vtk.hpp"
#include "view/drawing_device_vtk.hpp"

namespace fingerpad {

double ChartPlace::x_at(double drawing_x) const {
  const double share = std::clamp((drawing_x - panels.front().left) / panels.front().width, 0.0, 1.0);
  return x_min + share * (x_max - x_min);
}

double ChartPlace::drawing_x_at(double x) const {
  return panels.front().left + panels.front().width * std::clamp((x - x_min) / (x_max - x_min), 0.0, 1.0);
}

namespace {

ChartPlace draw(Drawing& drawing, const Chart& chart, const ChartLayout& layout) {
  ChartBoard board;
  const auto width = static_cast<int>(std::ceil(layout.page.right()));
  const auto height = static_cast<int>(std::ceil(layout.page.top()));
  board.show(chart, layout, width, height);
  drawing.append(recorded(board.items(), width, height));
  return board.place();
}

}  // namespace

ChartPlace draw_chart(Drawing& drawing, const Chart& chart, const Box& box, double text_size,
                      double least_left) {
  return draw(drawing, chart, stacked_layout(chart, box, text_size, least_left));
}

ChartPage chart_page(const Chart& chart) {
  const ChartLayout layout = page_layout(chart);
  ChartPage page{{}, static_cast<int>(layout.page.width), static_cast<int>(layout.page.height)};
  page.drawing.box(layout.page, colours::white);
  draw(page.drawing, chart, layout);
  return page;
}

}  // namespace fingerpad
