#pragma once

#include <string>
#include <vector>

#include "view/drawing.hpp"

namespace fingerpad {

/// What the flat parts over a scene stand on: it lets the scene shine through.
inline constexpr Colour panel_colour{255, 255, 255, 0.86};
void draw_panel(Drawing& drawing, const Box& box);

/// Words cut to a width, with dots where something was cut.
std::string fitted(const std::string& words, double size, bool bold, double width);
/// Words in lines of at most this width.
std::vector<std::string> wrapped(const std::string& words, double size, double width);

/// A line in a box of its own, about a point, and how wide that is.
double pill_width(const std::string& words, double em);
void paint_pill(Drawing& drawing, const Vec2& centre, const std::string& words, double em);

}  // namespace fingerpad
