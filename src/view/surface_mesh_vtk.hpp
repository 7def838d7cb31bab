#pragma once

#include <vtkSmartPointer.h>

#include "touch/world.hpp"
#include "view/draw_space.hpp"
#include "view/glyph_mesh.hpp"

class vtkPolyData;

namespace fingerpad {

/// A square of a plane about the point nearest to `about_W`, and the lines of its grid.
struct PlanePatch {
  vtkSmartPointer<vtkPolyData> square, grid;
};
PlanePatch plane_patch(const Surface& plane, const DrawSpace& space, const Vec3& about_W, double half_side_m,
                       double grid_m);

/// The solids as VTK has them, colours as scalars.
void copy_mesh(const GlyphMesh& mesh, vtkPolyData* out);

/// The path of the contact point (of the finger while free), without steps too small to see; the cell arrays
/// "phase" and "force" hold colours.
vtkSmartPointer<vtkPolyData> path_line(const ViewInput& input, const DrawSpace& space,
                                       const ViewExtent& extent);

}  // namespace fingerpad
