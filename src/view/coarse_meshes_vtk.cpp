#include "view/coarse_meshes_vtk.hpp"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataNormals.h>
#include <vtkQuadricClustering.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "part/part.hpp"
#include "touch/world.hpp"
#include "view/part_mesh_vtk.hpp"

namespace fingerpad {
namespace {

// Fewer are drawn within the time that is left of a smooth frame.
constexpr int least_triangles_to_coarsen = 30'000;
// Cells along a part's longest side: a surface fills some of their square, with two triangles a cell.
constexpr int cells_along = 56;

}  // namespace

vtkSmartPointer<vtkPolyData> coarse_mesh(const Surface& surface, const DrawSpace& space) {
  const auto whole = part_triangles(surface, space);
  vtkNew<vtkQuadricClustering> fewer;
  fewer->SetInputData(whole);
  fewer->AutoAdjustNumberOfDivisionsOff();
  double bounds[6];
  whole->GetBounds(bounds);
  const Vec3 size(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4]);
  const auto cells = [&](int axis) {
    return std::max(2, static_cast<int>(std::lround(cells_along * size[axis] / size.maxCoeff())));
  };
  fewer->SetNumberOfDivisions(cells(0), cells(1), cells(2));
  fewer->CopyCellDataOff();
  vtkNew<vtkPolyDataNormals> shaded;
  shaded->SetInputConnection(fewer->GetOutputPort());
  shaded->SetFeatureAngle(30);
  shaded->ConsistencyOff();
  shaded->Update();
  return shaded->GetOutput();
}

CoarseMeshes::CoarseMeshes(std::shared_ptr<const World> world, const DrawSpace& space)
    : meshes_(world ? world->surfaces.size() : 0) {
  maker_ = std::thread([this, world = std::move(world), space] {
    for (std::size_t i = 0; i < meshes_.size() && !unwanted_; ++i) {
      const Surface& surface = world->surfaces[i];
      if (!surface.part || surface.part->triangle_count() < least_triangles_to_coarsen) continue;
      meshes_[i] = coarse_mesh(surface, space);
    }
    ready_ = true;
  });
}

CoarseMeshes::~CoarseMeshes() {
  unwanted_ = true;
  maker_.join();
}

}  // namespace fingerpad
