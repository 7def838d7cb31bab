#include "view/clipping_range_vtk.hpp"

#include <vtkCamera.h>
#include <vtkPolyData.h>

#include <algorithm>

#include "fingerpad/types.hpp"

namespace fingerpad {

void set_clipping_range(vtkCamera* camera, vtkBoundingBox still, double radius_mm,
                        std::initializer_list<vtkPolyData*> all_moving) {
  if (!still.IsValid()) still.AddPoint(0, 0, 0);
  Vec3 centre;
  still.GetCenter(centre.data());
  double reach_mm = std::max(0.55 * still.GetDiagonalLength(), radius_mm);
  const double most_mm = 1e3 * reach_mm;  // farther away depths would tell nothing of the parts
  for (vtkPolyData* glyphs : all_moving) {
    if (glyphs->GetNumberOfPoints() == 0) continue;
    const vtkBoundingBox moving(glyphs->GetBounds());
    double corner[3];
    for (int i = 0; i < 8; ++i) {
      moving.GetCorner(i, corner);
      const double needed_mm = std::min((Vec3(corner) - centre).norm(), most_mm);
      while (reach_mm < needed_mm) reach_mm *= 2;
    }
  }
  const double along_mm =
      (centre - Vec3(camera->GetPosition())).dot(Vec3(camera->GetDirectionOfProjection()));
  const double far_mm = std::max(along_mm + reach_mm, 1e-3 * reach_mm);
  camera->SetClippingRange(std::max(along_mm - reach_mm, 1e-3 * far_mm), far_mm);
}

}  // namespace fingerpad
