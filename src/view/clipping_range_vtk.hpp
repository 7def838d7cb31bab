#pragma once

#include <vtkBoundingBox.h>

#include <initializer_list>

class vtkCamera;
class vtkPolyData;

namespace fingerpad {

/// The same for all moments, as far as that goes, so that what is still keeps its depths: a ball around
/// everything that is still, doubled until the finger and its arrows are within it.
/// @param still      bounds of what is still [mm]; may be invalid
/// @param radius_mm  the least reach of the ball
void set_clipping_range(vtkCamera* camera, vtkBoundingBox still, double radius_mm,
                        std::initializer_list<vtkPolyData*> all_moving);

}  // namespace fingerpad
