#include "view/close_up_vtk.hpp"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <cmath>

#include "base/tangent_frame.hpp"
#include "touch/world.hpp"
#include "view/camera_vtk.hpp"
#include "view/part_mesh_vtk.hpp"
#include "view/surface_mesh_vtk.hpp"

namespace fingerpad {
namespace {

vtkSmartPointer<vtkActor> near_actor(vtkProperty* property, double line_units) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->ScalarVisibilityOff();
  if (line_units != 0) mapper->SetRelativeCoincidentTopologyLineOffsetParameters(-1, line_units);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->SetProperty(property);
  return actor;
}

void set_mesh(vtkActor* actor, vtkPolyData* mesh) {
  vtkPolyDataMapper::SafeDownCast(actor->GetMapper())->SetInputData(mesh);
}

}  // namespace

void add_glyphs(vtkRenderer* renderer, vtkPolyData* mesh, bool outsides_alone) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(-3, -20);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetBackfaceCulling(outsides_alone ? 1 : 0);
  actor->GetProperty()->SetAmbient(0.35);
  actor->GetProperty()->SetDiffuse(0.65);
  renderer->AddActor(actor);
}

void light(vtkRenderer* renderer) {
  renderer->AutomaticLightCreationOff();
  const struct {
    double x, y, z, strength;
  } lamps[] = {{-0.5, 0.8, 1, 0.85}, {0.9, -0.2, 0.8, 0.4}, {0, -1, 0.6, 0.25}};
  for (const auto& lamp : lamps) {
    vtkNew<vtkLight> one;
    one->SetLightTypeToCameraLight();
    one->SetPosition(lamp.x, lamp.y, lamp.z);
    one->SetIntensity(lamp.strength);
    renderer->AddLight(one);
  }
}

CloseUp::CloseUp(const ViewInput& input, const DrawSpace& space, WorldProps& world)
    : input_(input), space_(space), world_(world), near_(input.world ? input.world->surfaces.size() : 0) {
  scene_->SetBackground(0.97, 0.975, 0.98);
  // The region is flat, the surface may not be: the marks are drawn over it.
  marks_->PreserveColorBufferOn();
  marks_->SetActiveCamera(scene_->GetActiveCamera());
  for (vtkRenderer* renderer : renderers()) {
    renderer->InteractiveOff();
    light(renderer);
  }
  for (std::size_t i = 0; i < near_.size(); ++i) {
    if (!input.world->surfaces[i].part) continue;
    near_[i].body = near_actor(world.part_property(), 0);
    near_[i].creases = near_actor(world.crease_property(), -4);
    scene_->AddActor(near_[i].body);
    scene_->AddActor(near_[i].creases);
  }
  world.add_surroundings_to(scene_);
  add_glyphs(marks_, clear_);
  add_glyphs(marks_, solid_);
}

void CloseUp::add_to(vtkRenderWindow* window) {
  for (vtkRenderer* renderer : renderers()) window->AddRenderer(renderer);
}

void CloseUp::hide() {
  for (vtkRenderer* renderer : renderers()) renderer->SetDraw(0);
}

void CloseUp::show(const ContactMoment& moment, const Box& box, const Box& window, double half_height_mm,
                   double limit_n, const GlyphInk& ink) {
  for (vtkRenderer* renderer : renderers()) {
    renderer->SetDraw(1);
    renderer->SetViewport(box.left / window.width, box.bottom / window.height, box.right() / window.width,
                          box.top() / window.height);
  }
  const TickRecord& row = moment.row;
  const ContactGlyphs glyphs = close_up_glyphs(moment, space_, limit_n, half_height_mm, ink);
  copy_mesh(glyphs.solid, solid_);
  copy_mesh(glyphs.clear, clear_);
  set_close_up_camera(scene_, space_.to_draw(row.contact_W),
                      tangent_frame(row.normal_W, moment.finger_direction_W), half_height_mm);
  // The camera sees a box, which reaches farther behind the contact than before it.
  vtkCamera* const camera = scene_->GetActiveCamera();
  const double far_mm = camera->GetClippingRange()[1] - camera->GetDistance();
  const double across_mm = half_height_mm * std::hypot(1.0, box.width / box.height);
  constexpr double spare = 1.02;
  show_parts_in(
      {row.contact_W, row.normal_W, 1e-3 * spare * std::hypot(far_mm, across_mm), 1e-3 * spare * across_mm});
}

void CloseUp::show_parts_in(const CloseUpSight& sight) {
  const bool moved = sight != shown_for_;
  shown_for_ = sight;
  if (moved) {
    for (Near& near : near_) near.made = false;
  }
  for (std::size_t i = 0; i < near_.size(); ++i) {
    if (!near_[i].body) continue;
    const bool shown = world_.is_shown(i);
    near_[i].body->SetVisibility(shown ? 1 : 0);
    near_[i].creases->SetVisibility(shown && world_.creases_shown() ? 1 : 0);
    if (!shown || near_[i].made) continue;
    near_[i].made = true;
    const Surface& surface = input_.world->surfaces[i];
    const PartPiece piece = part_piece(surface, space_, triangles_in_sight(surface, sight));
    set_mesh(near_[i].body, piece.mesh);
    set_mesh(near_[i].creases, piece.creases);
  }
}

}  // namespace fingerpad
