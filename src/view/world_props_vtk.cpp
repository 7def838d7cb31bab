#include "view/world_props_vtk.hpp"

#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkStaticCellLocator.h>

#include <algorithm>

#include "part/part.hpp"
#include "touch/world.hpp"
#include "view/axis.hpp"
#include "view/surface_mesh_vtk.hpp"

namespace fingerpad {
namespace {

vtkSmartPointer<vtkActor> actor_of(vtkPolyData* mesh) {
  auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
  mapper->SetInputData(mesh);
  mapper->ScalarVisibilityOff();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return actor;
}

void paint(vtkActor* actor, const Colour& colour) {
  vtkProperty* property = actor->GetProperty();
  property->SetColor(colour.red / 255.0, colour.green / 255.0, colour.blue / 255.0);
  property->SetOpacity(colour.opacity);
}

vtkSmartPointer<vtkActor> line_actor(vtkPolyData* mesh, const Colour& colour) {
  auto actor = actor_of(mesh);
  paint(actor, colour);
  actor->GetProperty()->LightingOff();
  // In front of the faces that the lines lie on.
  actor->GetMapper()->SetRelativeCoincidentTopologyLineOffsetParameters(-1, -4);
  return actor;
}

}  // namespace

WorldProps::WorldProps(const ViewInput& input, const DrawSpace& space, const ViewExtent& extent)
    : world_(input.world), space_(space) {
  if (world_) {
    for (const Surface& surface : world_->surfaces) {
      if (surface.part) {
        add_part(surface);
      } else {
        add_plane(surface, extent);
      }
    }
  }
  shown_.assign(surfaces_.size(), true);
  if (input.rows.size() < 2) return;
  const auto line = path_line(input, space, extent);
  path_ = line_actor(line, colours::ink);
  path_->GetMapper()->SetRelativeCoincidentTopologyLineOffsetParameters(-2, -16);
  path_->GetMapper()->ScalarVisibilityOn();
  path_->GetMapper()->SetScalarModeToUseCellFieldData();
  path_->GetMapper()->SelectColorArray("phase");
}

void WorldProps::add_part(const Surface& surface) {
  meshes_.push_back(part_mesh(surface, space_));
  auto body = actor_of(meshes_.back());
  paint(body, colours::metal);
  vtkProperty* property = body->GetProperty();
  property->SetInterpolationToPhong();
  property->SetAmbient(0.2);
  property->SetDiffuse(0.82);
  property->SetSpecular(0.22);
  property->SetSpecularPower(28);
  surfaces_.push_back(body);
  creases_.push_back(line_actor(crease_lines(surface, space_), {52, 60, 70}));
}

void WorldProps::add_plane(const Surface& surface, const ViewExtent& extent) {
  meshes_.emplace_back();
  const Ball about = extent.path ? *extent.path : extent.everything();
  const double half_side_m = std::max(1.35 * about.radius_m, extent.parts ? extent.parts->radius_m : 1e-3);
  grid_m_ = round_down_125(half_side_m / 4);
  const PlanePatch patch = plane_patch(surface, space_, about.centre_W, half_side_m, grid_m_);
  auto square = actor_of(patch.square);
  paint(square, Colour{206, 214, 224, extent.parts ? 0.45 : 0.8});
  square->GetProperty()->SetAmbient(0.5);
  square->GetProperty()->SetDiffuse(0.5);
  surfaces_.push_back(square);
  grids_.push_back(line_actor(patch.grid, {150, 162, 176}));
}

void WorldProps::add_to(vtkRenderer* renderer) const {
  for (const auto* actors : {&surfaces_, &grids_, &creases_}) {
    for (const auto& actor : *actors) renderer->AddActor(actor);
  }
  if (path_) renderer->AddActor(path_);
}

// Parts come before planes: creases are counted as parts are, grids as planes.
void WorldProps::show_creases(bool shown) {
  for (std::size_t i = 0; i < creases_.size(); ++i) creases_[i]->SetVisibility(shown && shown_[i] ? 1 : 0);
  creases_shown_ = shown;
}

void WorldProps::show_surface(std::size_t index, bool shown) {
  shown_[index] = shown;
  surfaces_[index]->SetVisibility(shown ? 1 : 0);
  if (index >= creases_.size()) grids_[index - creases_.size()]->SetVisibility(shown ? 1 : 0);
  show_creases(creases_shown_);
}

void WorldProps::show_path(bool shown, bool by_force) {
  if (!path_) return;
  path_->SetVisibility(shown ? 1 : 0);
  path_->GetMapper()->SelectColorArray(by_force ? "force" : "phase");
}

void WorldProps::show_as_wires(bool wires) {
  for (std::size_t i = 0; i < surfaces_.size(); ++i) {
    if (!meshes_[i]) continue;
    vtkProperty* property = surfaces_[i]->GetProperty();
    wires ? property->SetRepresentationToWireframe() : property->SetRepresentationToSurface();
  }
}

void WorldProps::set_line_width(double px) {
  for (const auto* actors : {&creases_, &grids_}) {
    for (const auto& actor : *actors) actor->GetProperty()->SetLineWidth(static_cast<float>(px));
  }
  if (path_) path_->GetProperty()->SetLineWidth(static_cast<float>(2.6 * px));
}

void WorldProps::build_locators() {
  for (const auto& mesh : meshes_) {
    locators_.emplace_back();
    if (!mesh) continue;
    locators_.back() = vtkSmartPointer<vtkStaticCellLocator>::New();
    locators_.back()->SetDataSet(mesh);
    locators_.back()->BuildLocator();
  }
}

std::optional<SurfaceHit> WorldProps::first_hit(const Vec3& a_mm, const Vec3& b_mm) {
  if (!world_) return std::nullopt;
  if (locators_.size() != meshes_.size()) build_locators();
  std::optional<SurfaceHit> first;
  for (std::size_t i = 0; i < world_->surfaces.size(); ++i) {
    const Surface& surface = world_->surfaces[i];
    if (!shown_[i]) continue;
    SurfaceHit hit;
    hit.surface = static_cast<int>(i);
    if (surface.part) {
      double x[3], within[3];
      int sub = 0;
      vtkIdType cell = -1;
      if (locators_[i]->IntersectWithLine(a_mm.data(), b_mm.data(), 1e-9, hit.along, x, within, sub, cell) ==
          0) {
        continue;
      }
      hit.point_W = space_.to_world(Vec3(x[0], x[1], x[2]));
      hit.normal_W = surface.R_WP * surface.part->facet_normals.col(cell);
    } else {
      const Vec3 a_W = space_.to_world(a_mm);
      const Vec3 way = space_.to_world(b_mm) - a_W;
      const double fall = way.dot(surface.plane_normal_W);
      if (!(fall < 0)) continue;  // seen from behind, or along
      hit.along = (surface.plane_point_W - a_W).dot(surface.plane_normal_W) / fall;
      if (!(hit.along >= 0 && hit.along <= 1)) continue;
      hit.point_W = a_W + hit.along * way;
      hit.normal_W = surface.plane_normal_W;
    }
    if (!first || hit.along < first->along) first = hit;
  }
  return first;
}

}  // namespace fingerpad
