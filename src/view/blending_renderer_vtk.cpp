#include "view/blending_renderer_vtk.hpp"

#include <vtkObjectFactory.h>

namespace fingerpad {

vtkStandardNewMacro(BlendingRenderer);

}  // namespace fingerpad
