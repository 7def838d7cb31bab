#pragma once

#include <string>

#include "view/drawing.hpp"

namespace fingerpad {

/// Writes a drawing as PNG on white. Starts a virtual screen where there is none. Throws Error as
/// VirtualScreen does, and (fault) where the file cannot be written.
void write_flat_png(const Drawing& drawing, int width, int height, const std::string& path);

}  // namespace fingerpad
