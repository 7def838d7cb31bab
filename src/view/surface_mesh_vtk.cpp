#include "view/surface_mesh_vtk.hpp"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>

#include "base/tangent_frame.hpp"
#include "touch/world.hpp"
#include "view/overlay.hpp"
#include "view/part_mesh_vtk.hpp"

namespace fingerpad {
namespace {

vtkSmartPointer<vtkUnsignedCharArray> new_colours(const char* name, int components) {
  auto colours = vtkSmartPointer<vtkUnsignedCharArray>::New();
  colours->SetNumberOfComponents(components);
  colours->SetName(name);
  return colours;
}

}  // namespace

PlanePatch plane_patch(const Surface& plane, const DrawSpace& space, const Vec3& about_W, double half_side_m,
                       double grid_m) {
  const Vec3& normal = plane.plane_normal_W;
  const Mat3 frame = tangent_frame(normal, std::abs(normal.y()) < 0.9 ? Vec3::UnitY() : Vec3::UnitX());
  // The grid's lines pass through the plane's own point, so they stay where the view moves.
  const Vec3 offset = about_W - plane.plane_point_W;
  const Vec3 middle = plane.plane_point_W +
                      frame.col(0) * grid_m * std::round(frame.col(0).dot(offset) / grid_m) +
                      frame.col(1) * grid_m * std::round(frame.col(1).dot(offset) / grid_m);
  const auto at = [&](double u, double v) {
    return space.to_draw(middle + frame.col(0) * u + frame.col(1) * v);
  };
  PlanePatch patch{vtkSmartPointer<vtkPolyData>::New(), vtkSmartPointer<vtkPolyData>::New()};
  const int cells = std::max(1, static_cast<int>(std::ceil(half_side_m / grid_m)));
  const double half_m = cells * grid_m;

  auto points = vtkSmartPointer<vtkPoints>::New();
  auto quads = vtkSmartPointer<vtkCellArray>::New();
  const auto normals = new_normals();
  const vtkIdType ids[] = {0, 1, 2, 3};
  for (const Vec3& corner :
       {at(-half_m, -half_m), at(half_m, -half_m), at(half_m, half_m), at(-half_m, half_m)}) {
    points->InsertNextPoint(corner.data());
    normals->InsertNextTuple(normal.data());
  }
  quads->InsertNextCell(4, ids);
  patch.square->SetPoints(points);
  patch.square->SetPolys(quads);
  patch.square->GetPointData()->SetNormals(normals);

  auto grid_points = vtkSmartPointer<vtkPoints>::New();
  auto lines = vtkSmartPointer<vtkCellArray>::New();
  for (int i = -cells; i <= cells; ++i) {
    add_segment(grid_points, lines, at(i * grid_m, -half_m), at(i * grid_m, half_m));
    add_segment(grid_points, lines, at(-half_m, i * grid_m), at(half_m, i * grid_m));
  }
  patch.grid->SetPoints(grid_points);
  patch.grid->SetLines(lines);
  return patch;
}

void copy_mesh(const GlyphMesh& mesh, vtkPolyData* out) {
  auto points = vtkSmartPointer<vtkPoints>::New();
  const auto normals = new_normals();
  const auto colours = new_colours("colour", 4);
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    points->InsertNextPoint(mesh.points[i].data());
    normals->InsertNextTuple(mesh.normals[i].data());
    colours->InsertNextTypedTuple(mesh.colours[i].data());
  }
  for (const auto& triangle : mesh.triangles) {
    const vtkIdType ids[] = {triangle[0], triangle[1], triangle[2]};
    cells->InsertNextCell(3, ids);
  }
  out->Initialize();
  out->SetPoints(points);
  out->SetPolys(cells);
  out->GetPointData()->SetNormals(normals);
  out->GetPointData()->SetScalars(colours);
}

vtkSmartPointer<vtkPolyData> path_line(const ViewInput& input, const DrawSpace& space,
                                       const ViewExtent& extent) {
  // Steps far below a pixel leave gaps in a wide line, and cost time.
  const double least_step_mm = extent.path ? 2e-3 * 1e3 * extent.path->radius_m : 0;
  auto points = vtkSmartPointer<vtkPoints>::New();
  auto lines = vtkSmartPointer<vtkCellArray>::New();
  const auto by_phase = new_colours("phase", 3);
  const auto by_force = new_colours("force", 3);
  vtkIdType last = -1;
  Vec3 last_at = Vec3::Zero();
  for (std::size_t i = 0; i < input.rows.size(); ++i) {
    const TickRecord& row = input.rows[i];
    const Vec3 at = space.to_draw(row.phase == Phase::free ? row.p_WQ : row.contact_W);
    const bool turns = i + 1 == input.rows.size() || input.rows[i + 1].phase != row.phase;
    if (last >= 0 && !turns && (at - last_at).norm() < least_step_mm) continue;
    const vtkIdType here = points->InsertNextPoint(at.data());
    if (last >= 0) {
      const vtkIdType ids[] = {last, here};
      lines->InsertNextCell(2, ids);
      const double share = extent.max_force_n > 0 ? row.force_W_n.norm() / extent.max_force_n : 0;
      const Colour phase = phase_colour(row.phase);
      const Colour force = ramp_colour(share);
      const std::uint8_t phase_rgb[] = {phase.red, phase.green, phase.blue};
      const std::uint8_t force_rgb[] = {force.red, force.green, force.blue};
      by_phase->InsertNextTypedTuple(phase_rgb);
      by_force->InsertNextTypedTuple(force_rgb);
    }
    last = here;
    last_at = at;
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetLines(lines);
  mesh->GetCellData()->AddArray(by_phase);
  mesh->GetCellData()->AddArray(by_force);
  return mesh;
}

}  // namespace fingerpad
