#pragma once

#include <string>

#include "view/pixels.hpp"

class vtkRenderWindow;

namespace fingerpad {

/// What a window shows.
Pixels pixels_of(vtkRenderWindow* window);

/// Writes what a window shows as PNG: first as `path`.part, renamed when whole. Throws Error as
/// OutputFile does.
void write_png(vtkRenderWindow* window, const std::string& path);
void write_png(const Pixels& picture, const std::string& path);

}  // namespace fingerpad
