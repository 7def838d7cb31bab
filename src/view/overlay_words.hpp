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
/// Words cut in their middle to a width, where a name says least: its beginning and its end stay.
std::string fitted_in_middle(const std::string& words, double size, bool bold, double width);
/// Words in lines of at most this width.
std::vector<std::string> wrapped(const std::string& words, double size, double width, bool bold = false);

/// A few lines in a box of their own, about a point, and how large that is; (0, 0) without lines.
Vec2 pill_size(const std::vector<std::string>& lines, double em);
void paint_pill(Drawing& drawing, const Vec2& centre, const std::vector<std::string>& lines, double em);

}  // namespace fingerpad
