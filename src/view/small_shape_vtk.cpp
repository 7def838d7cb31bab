#include <vtkCellArray.h>
#include <vtkCleanPolyData.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkQuadricClustering.h>
#include <vtkQuadricDecimation.h>
#include <vtkSmartPointer.h>
#include <vtkTriangleFilter.h>

#include <algorithm>
#include <cmath>

#include "base/tangent_frame.hpp"
#include "part/part.hpp"
#include "view/small_shape.hpp"

namespace fingerpad {
namespace {

/// Above so many a grid takes the most of them first: a collapse edge by edge costs some 10 us a triangle.
constexpr int most_to_collapse = 60'000;
constexpr int first_cells_along = 160;

/// Welded, so that edges can be collapsed; about the part's own centre.
vtkSmartPointer<vtkPolyData> welded_triangles(const Part& part) {
  vtkNew<vtkPoints> points;
  points->SetNumberOfPoints(part.welded_count);
  vtkNew<vtkCellArray> cells;
  for (Eigen::Index t = 0; t < part.triangles.cols(); ++t) {
    vtkIdType ids[3];
    for (int corner = 0; corner < 3; ++corner) {
      ids[corner] = part.welded(corner, t);
      const Vec3 at = part.vertices.col(part.triangles(corner, t)) * 1e3;
      points->SetPoint(ids[corner], at.data());
    }
    if (ids[0] != ids[1] && ids[1] != ids[2] && ids[2] != ids[0]) cells->InsertNextCell(3, ids);
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(cells);
  return mesh;
}

vtkSmartPointer<vtkPolyData> clustered(vtkPolyData* whole, int cells_along) {
  double bounds[6];
  whole->GetBounds(bounds);
  const Vec3 size(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4]);
  const auto cells = [&](int axis) {
    return std::max(2, static_cast<int>(std::lround(cells_along * size[axis] / size.maxCoeff())));
  };
  vtkNew<vtkQuadricClustering> fewer;
  fewer->SetInputData(whole);
  fewer->AutoAdjustNumberOfDivisionsOff();
  fewer->SetNumberOfDivisions(cells(0), cells(1), cells(2));
  fewer->CopyCellDataOff();
  fewer->Update();
  return fewer->GetOutput();
}

/// At most some `most` triangles of a mesh.
vtkSmartPointer<vtkPolyData> decimated(vtkSmartPointer<vtkPolyData> mesh, int most) {
  if (mesh->GetNumberOfPolys() <= most) return mesh;
  if (mesh->GetNumberOfPolys() > most_to_collapse) mesh = clustered(mesh, first_cells_along);
  vtkNew<vtkQuadricDecimation> fewer;
  fewer->SetInputData(mesh);
  fewer->SetTargetReduction(1 - static_cast<double>(most) / static_cast<double>(mesh->GetNumberOfPolys()));
  fewer->VolumePreservationOn();
  fewer->Update();
  vtkSmartPointer<vtkPolyData> result = fewer->GetOutput();
  // Torn meshes keep more than was asked for.
  for (int along = 64; result->GetNumberOfPolys() > most + most / 10 && along >= 4; along = along * 3 / 4) {
    result = clustered(mesh, along);
  }
  return result;
}

void add_part(const Surface& surface, int most, SmallShape& shape) {
  const auto mesh = decimated(welded_triangles(*surface.part), most);
  vtkNew<vtkCleanPolyData> used;  // without the points that nothing is left of
  used->SetInputData(mesh);
  used->PointMergingOff();
  used->Update();
  vtkPolyData* const left = used->GetOutput();
  const int first = static_cast<int>(shape.points_W.size());
  for (vtkIdType i = 0; i < left->GetNumberOfPoints(); ++i) {
    const Vec3 at = Vec3(left->GetPoint(i)) * 1e-3;
    shape.points_W.emplace_back(surface.p_WP + surface.R_WP * (surface.part->centre_P + at));
  }
  vtkNew<vtkIdList> ids;
  vtkCellArray* const cells = left->GetPolys();
  for (cells->InitTraversal(); cells->GetNextCell(ids) != 0;) {
    if (ids->GetNumberOfIds() != 3) continue;
    const auto corner = [&](int k) { return first + static_cast<int>(ids->GetId(k)); };
    shape.triangles.push_back({corner(0), corner(1), corner(2)});
  }
}

void add_plane(const Surface& plane, const Ball& about, SmallShape& shape) {
  const Vec3& normal = plane.plane_normal_W;
  const Mat3 frame = tangent_frame(normal, std::abs(normal.y()) < 0.9 ? Vec3::UnitY() : Vec3::UnitX());
  const Vec3 foot = about.centre_W - normal * normal.dot(about.centre_W - plane.plane_point_W);
  const double half_m = 1.3 * std::max(about.radius_m, 1e-3);
  const int first = static_cast<int>(shape.points_W.size());
  for (const auto& [u, v] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
    shape.points_W.emplace_back(foot + half_m * (u * frame.col(0) + v * frame.col(1)));
  }
  shape.triangles.push_back({first, first + 1, first + 2});
  shape.triangles.push_back({first, first + 2, first + 3});
}

}  // namespace

SmallShape small_shape(std::span<const Surface> surfaces, int most_triangles, const Ball& about) {
  const int all = triangles_of(surfaces);
  SmallShape shape;
  for (const Surface& surface : surfaces) {
    if (!surface.part) {
      add_plane(surface, about, shape);
      continue;
    }
    const double share = surface.part->triangle_count() / std::max<double>(all, 1);
    add_part(surface, std::max(12, static_cast<int>(share * most_triangles)), shape);
  }
  return shape;
}

}  // namespace fingerpad
