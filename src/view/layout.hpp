#pragma once

#include "view/drawing.hpp"

namespace fingerpad {

/// Where things stand in a picture or window.
struct Layout {
  double em = 12;  ///< size of texts [px]
  Box window, title, scene;
  Box charts;              ///< empty without rows
  Box timeline;            ///< empty without rows
  Box inset, other_inset;  ///< within scene: where the close-up stands, and where it makes way
};

/// @param charts    a column of charts stands on the right
/// @param timeline  a bar with the time stands at the bottom
Layout layout_for(int width, int height, bool charts, bool timeline);

}  // namespace fingerpad
