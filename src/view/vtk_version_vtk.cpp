#include <vtkVersion.h>

#include "view/vtk_version.hpp"

namespace fingerpad {

std::string vtk_version() {
  return vtkVersion::GetVTKVersion();
}

}  // namespace fingerpad
