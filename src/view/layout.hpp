#pragma once

#include "view/drawing.hpp"

namespace fingerpad {

/// Where things stand in a picture or window.
struct Layout {
  double em = 12;  ///< size of texts [px]
  Box window, title, scene;
  Box charts;    ///< empty without rows
  Box timeline;  ///< empty without rows
  Box inset;     ///< within scene: where the close-up mostly stands
};

/// A window that is told to be smaller than this stays as it is, where a window manager listens.
inline constexpr int least_window_width_px = 400, least_window_height_px = 300;
/// Below this the charts' numbers would meet, and the scene needs the room.
inline constexpr int least_width_with_charts_px = 540, least_height_with_charts_px = 360;

/// So high above the scene's foot are the axes in its lower right corner, whichever of them points upwards.
inline constexpr double axes_foot_em = 7.2;
/// So far the scale bar reaches from the scene's right side, beside them.
inline constexpr double scale_bar_reach_em = 17.5;

/// @param charts    a column of charts stands on the right, where there is room for it
/// @param timeline  a bar with the time stands at the bottom
Layout layout_for(int width, int height, bool charts, bool timeline);

}  // namespace fingerpad
