#pragma once

#include <string>

namespace fingerpad {

/// Of VTK as it is loaded, as "9.1.0".
std::string vtk_version();

}  // namespace fingerpad
