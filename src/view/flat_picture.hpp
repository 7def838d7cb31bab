#pragma once

#include <string>

#include "view/drawing.hpp"
#include "view/pixels.hpp"

namespace fingerpad {

/// Writes a drawing as PNG on white. Starts a virtual screen where there is none. Throws Error as
/// VirtualScreen and OutputFile do.
void write_flat_png(const Drawing& drawing, int width, int height, const std::string& path);

/// The pixels of such a picture, painted strip by strip from the bottom up, so that a large page takes little
/// more memory than its pixels.
Pixels flat_pixels_in_strips(const Drawing& drawing, int width, int height, int strip_height);

}  // namespace fingerpad
