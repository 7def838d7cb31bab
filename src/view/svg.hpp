#pragma once

#include <string>

#include "view/drawing.hpp"

namespace fingerpad {

/// A drawing as an SVG page, texts as text. The same drawing gives the same bytes; no screen is needed.
std::string svg_page(const Drawing& drawing, int width, int height, const std::string& title);

/// Writes svg_page to a file. Throws Error as OutputFile does.
void write_svg(const Drawing& drawing, int width, int height, const std::string& title,
               const std::string& path);

}  // namespace fingerpad
