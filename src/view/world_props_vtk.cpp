#include "view/world_props_vtk.hpp"

#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <string_view>

#include "part/part.hpp"
#include "touch/finger_room.hpp"
#include "touch/world.hpp"
#include "view/axis.hpp"
#include "view/part_mesh_vtk.hpp"
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

void paint(vtkProperty* property, const Colour& colour) {
  property->SetColor(colour.red / 255.0, colour.green / 255.0, colour.blue / 255.0);
  property->SetOpacity(colour.opacity);
}

vtkSmartPointer<vtkActor> line_actor(vtkPolyData* mesh, const Colour& colour) {
  auto actor = actor_of(mesh);
  paint(actor->GetProperty(), colour);
  actor->GetProperty()->LightingOff();
  // In front of the faces that the lines lie on.
  actor->GetMapper()->SetRelativeCoincidentTopologyLineOffsetParameters(-1, -4);
  return actor;
}

}  // namespace

WorldProps::WorldProps(const ViewInput& input, const DrawSpace& space, const ViewExtent& extent)
    : world_(input.world),
      space_(space),
      shown_(world_ ? world_->surfaces.size() : 0),
      part_property_(vtkSmartPointer<vtkProperty>::New()),
      crease_property_(vtkSmartPointer<vtkProperty>::New()) {
  for (auto& shown : shown_) shown = true;
  paint(part_property_, colours::metal);
  part_property_->SetInterpolationToPhong();
  part_property_->SetAmbient(0.2);
  part_property_->SetDiffuse(0.82);
  part_property_->SetSpecular(0.22);
  part_property_->SetSpecularPower(28);
  paint(crease_property_, {52, 60, 70});
  crease_property_->LightingOff();
  if (world_) {
    for (const Surface& surface : world_->surfaces) {
      if (surface.part) {
        add_part(surface);
      } else {
        add_plane(surface, extent);
      }
    }
  }
  if (input.rows.size() < 2) return;
  const auto line = path_line(input, space, extent);
  path_ = line_actor(line, colours::ink);
  path_->GetMapper()->SetRelativeCoincidentTopologyLineOffsetParameters(-2, -16);
  path_->GetMapper()->ScalarVisibilityOn();
  path_->GetMapper()->SetScalarModeToUseCellFieldData();
  path_->GetMapper()->SelectColorArray("phase");
  bounds_mm_.AddBounds(line->GetBounds());
}

void WorldProps::add_part(const Surface& surface) {
  SurfaceProps props;
  const auto mesh = part_mesh(surface, space_);
  props.body = actor_of(mesh);
  props.body->SetProperty(part_property_);
  props.creases = line_actor(crease_lines(surface, space_), {});
  props.creases->SetProperty(crease_property_);
  bounds_mm_.AddBounds(mesh->GetBounds());
  surfaces_.push_back(std::move(props));
}

void WorldProps::add_plane(const Surface& surface, const ViewExtent& extent) {
  const Ball about = extent.path ? *extent.path : extent.everything();
  const double half_side_m = std::max(1.35 * about.radius_m, extent.parts ? extent.parts->radius_m : 1e-3);
  grid_m_ = round_down_125(half_side_m / 4);
  const PlanePatch patch = plane_patch(surface, space_, about.centre_W, half_side_m, grid_m_);
  SurfaceProps props;
  props.square = actor_of(patch.square);
  paint(props.square->GetProperty(), Colour{206, 214, 224, extent.parts ? 0.45 : 0.8});
  props.square->GetProperty()->SetAmbient(0.5);
  props.square->GetProperty()->SetDiffuse(0.5);
  props.grid = line_actor(patch.grid, {150, 162, 176});
  bounds_mm_.AddBounds(patch.grid->GetBounds());
  surfaces_.push_back(std::move(props));
}

void WorldProps::add_still_to(vtkRenderer* renderer) {
  for (const auto which : {&SurfaceProps::body, &SurfaceProps::grid, &SurfaceProps::creases}) {
    for (const SurfaceProps& props : surfaces_) {
      if (props.*which) renderer->AddActor(props.*which);
    }
  }
  if (path_) renderer->AddActor(path_);
  still_in_ = renderer;
}

void WorldProps::add_clear_to(vtkRenderer* renderer) const {
  for (const SurfaceProps& props : surfaces_) {
    if (props.square) renderer->AddActor(props.square);
  }
}

void WorldProps::add_surroundings_to(vtkRenderer* renderer) const {
  add_clear_to(renderer);
  for (const SurfaceProps& props : surfaces_) {
    if (props.grid) renderer->AddActor(props.grid);
  }
  if (path_) renderer->AddActor(path_);
}

void WorldProps::apply_visibility() {
  const auto show = [](vtkActor* actor, bool shown) {
    if (actor != nullptr) actor->SetVisibility(shown ? 1 : 0);
  };
  for (std::size_t i = 0; i < surfaces_.size(); ++i) {
    const SurfaceProps& props = surfaces_[i];
    const bool shown = is_shown(i), coarse = coarse_ && props.coarse_body;
    show(props.body, shown && !coarse);
    show(props.coarse_body, shown && coarse);
    show(props.creases, shown && creases_shown_ && !coarse);
    show(props.square, shown);
    show(props.grid, shown);
  }
}

void WorldProps::show_surface(std::size_t index, bool shown) {
  shown_[index] = shown;
  apply_visibility();
}

void WorldProps::show_wireframe(bool wireframe) {
  part_property_->SetRepresentation(wireframe ? VTK_WIREFRAME : VTK_SURFACE);
}

void WorldProps::show_creases(bool shown) {
  creases_shown_ = shown;
  apply_visibility();
}

void WorldProps::set_coarse(const std::vector<vtkSmartPointer<vtkPolyData>>& meshes) {
  for (std::size_t i = 0; i < surfaces_.size() && i < meshes.size(); ++i) {
    if (!meshes[i] || surfaces_[i].coarse_body) continue;
    surfaces_[i].coarse_body = actor_of(meshes[i]);
    surfaces_[i].coarse_body->SetProperty(part_property_);
    if (still_in_ != nullptr) still_in_->AddActor(surfaces_[i].coarse_body);
  }
  apply_visibility();
}

void WorldProps::show_coarse(bool coarse) {
  if (coarse == coarse_) return;
  coarse_ = coarse;
  apply_visibility();
}

void WorldProps::show_path(bool shown, bool by_force) {
  if (!path_) return;
  path_->SetVisibility(shown ? 1 : 0);
  const std::string_view now = path_->GetMapper()->GetArrayName(), wanted = by_force ? "force" : "phase";
  if (now != wanted)
    path_->GetMapper()->SelectColorArray(wanted.data());  // which makes all that is kept stale
}

void WorldProps::set_line_width(double px) {
  crease_property_->SetLineWidth(static_cast<float>(px));
  for (const SurfaceProps& props : surfaces_) {
    if (props.grid) props.grid->GetProperty()->SetLineWidth(static_cast<float>(px));
  }
  if (path_) path_->GetProperty()->SetLineWidth(static_cast<float>(2.6 * px));
}

std::optional<SurfaceHit> WorldProps::first_hit(const Vec3& a_mm, const Vec3& b_mm) const {
  if (!world_) return std::nullopt;
  const Vec3 a_W = space_.to_world(a_mm), b_W = space_.to_world(b_mm);
  std::optional<SurfaceHit> first;
  for (std::size_t i = 0; i < world_->surfaces.size(); ++i) {
    if (!is_shown(i)) continue;
    auto hit = line_hit(world_->surfaces[i], a_W, b_W);
    if (!hit || (first && hit->along >= first->along)) continue;
    hit->surface = static_cast<int>(i);
    first = hit;
  }
  return first;
}

std::optional<SurfaceHit> WorldProps::finger_hit(const Vec3& a_mm, const Vec3& b_mm, double radius_m) const {
  const auto hit = first_hit(a_mm, b_mm);
  if (!world_) return hit;
  const Vec3 a_W = space_.to_world(a_mm), b_W = space_.to_world(b_mm), up_W = (a_W - b_W).normalized();
  Looks looks(room_looks);
  std::optional<RimPlace> rim;
  if (hit) {
    const Vec3 seen_W = hit->normal_W.dot(up_W) < 0 ? Vec3(-hit->normal_W) : hit->normal_W;
    rim = rim_before(*world_, a_W, hit->point_W, seen_W, radius_m, looks);
  } else {
    rim = rim_on_line(*world_, a_W, b_W, radius_m, looks);
  }
  if (!rim || !is_shown(static_cast<std::size_t>(rim->surface))) return hit;
  return SurfaceHit{rim->centre_W - radius_m * up_W, up_W, rim->surface, 0, true};
}

}  // namespace fingerpad
