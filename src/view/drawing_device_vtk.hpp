#pragma once

#include <span>

#include "view/drawing.hpp"

class vtkAbstractContextItem;
class vtkContext2D;
class vtkContextScene;

namespace fingerpad {

/// What a scene of VTK paints, as a drawing. Needs no screen.
Drawing recorded(vtkContextScene* scene);

/// What items of VTK paint in a scene of their own.
/// @param width, height  of the page [px]
Drawing recorded(std::span<vtkAbstractContextItem* const> items, int width, int height);

/// The drawing that a painter records into; null where it paints on a screen.
Drawing* recording_of(vtkContext2D* painter);

}  // namespace fingerpad
