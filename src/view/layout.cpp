#include "view/layout.hpp"

#include <algorithm>
#include <cmath>

namespace fingerpad {

Layout layout_for(int width, int height, bool charts, bool timeline) {
  Layout layout;
  charts = charts && width >= least_width_with_charts_px && height >= least_height_with_charts_px;
  layout.em = std::round(std::clamp(std::min(width / 74.0, height / 52.0), 9.0, 16.0));
  const double em = layout.em;
  layout.window = {0, 0, static_cast<double>(width), static_cast<double>(height)};
  // Of whole pixels, as the scene's viewport is.
  const double bar = timeline ? std::round(2.6 * em) : 0;
  const double head = std::round(2.2 * em);
  layout.timeline = {0, 0, layout.window.width, bar};
  layout.title = {0, height - head, layout.window.width, head};
  const double column = charts ? std::round(std::clamp(0.37 * width, 20 * em, 44 * em)) : 0;
  layout.scene = {0, bar, width - column, height - head - bar};
  layout.charts = {layout.scene.right(), bar, column, layout.scene.height};
  const double side = 0.34 * std::min(layout.scene.width, layout.scene.height);
  layout.inset = {layout.scene.right() - side - 0.7 * em, layout.scene.top() - side - 0.7 * em, side, side};
  return layout;
}

}  // namespace fingerpad
