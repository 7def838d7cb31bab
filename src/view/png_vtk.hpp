#pragma once

#include <string>

class vtkRenderWindow;

namespace fingerpad {

/// Writes what a window shows as PNG: first as `path`.part, renamed when whole. Throws Error (fault).
void write_png(vtkRenderWindow* window, const std::string& path);

}  // namespace fingerpad
