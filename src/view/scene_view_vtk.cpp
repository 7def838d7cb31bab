#include "view/scene_view_vtk.hpp"

#include <vtkCamera.h>
#include <vtkRenderer.h>

#include <algorithm>

#include "view/overlay_hud.hpp"

namespace fingerpad {

SceneView::SceneView(vtkRenderer* renderer, const ViewInput& input, const ViewExtent& extent,
                     const DrawSpace& space)
    : renderer_(renderer), input_(input), extent_(extent), space_(space) {}

vtkCamera* SceneView::camera() const {
  return renderer_->GetActiveCamera();
}

void SceneView::lay_out(const Layout& layout) {
  const bool is_fitted = !fitted_.empty() && view_of(camera()) == fitted_;
  layout_ = layout;
  make_way_for_readings();
  if (is_fitted) fit();
}

/// Brings what is looked at to the size of the scene.
void SceneView::fit() {
  if (look_) {
    set_look(renderer_, input_, extent_, space_, *look_, width_to_height());
    if (finger_)
      take_in_finger(renderer_, input_, extent_, space_, *finger_, width_to_height(), layout_.scene.height);
  } else {
    set_scene_camera(renderer_, input_, looked_at_ ? &*looked_at_ : nullptr, extent_, space_,
                     width_to_height());
  }
  fitted_ = view_of(camera());
}

void SceneView::reset(const std::optional<LookFrom>& look, const TickRecord* shown) {
  look_ = look;
  finger_.reset();
  looked_at_.reset();
  if (shown != nullptr) looked_at_ = *shown;
  fit();
}

void SceneView::look(const LookFrom& from, const std::optional<FingerInSight>& finger) {
  look_ = from;
  finger_ = finger;
  fit();
}

void SceneView::look_at_all(const std::optional<FingerInSight>& finger) {
  const Mat3 axes = axes_on_screen(renderer_);
  look({axes.row(2), axes.row(1)}, finger);
}

void SceneView::zoom(double factor) {
  const double scale = camera()->GetParallelScale() / factor;
  const double whole_mm = 1e3 * extent_.everything().radius_m;
  camera()->SetParallelScale(std::clamp(scale, 1e-5 * whole_mm, 30 * whole_mm));
}

void SceneView::keep_clear_of_readings() {
  clear_of_readings_ = true;
  make_way_for_readings();
}

/// The strip at the left in which the readings stand, where the scene is wide enough to spare it.
double SceneView::readings_strip_px() const {
  const double strip = (readings_width_em + 1.4) * layout_.em;
  return clear_of_readings_ && layout_.scene.width > 3 * strip ? strip : 0;
}

double SceneView::width_to_height() const {
  return (layout_.scene.width - readings_strip_px()) / layout_.scene.height;
}

/// What is in the middle comes to the middle of what is left of the scene; views still turn round it.
void SceneView::make_way_for_readings() {
  camera()->SetWindowCenter(-readings_strip_px() / layout_.scene.width, 0);
}

double SceneView::px_per_mm() const {
  return layout_.scene.height / (2 * camera()->GetParallelScale());
}

Vec2 SceneView::on_screen(const Vec3& p_mm) const {
  renderer_->SetWorldPoint(p_mm.x(), p_mm.y(), p_mm.z(), 1);
  renderer_->WorldToDisplay();
  const double* px = renderer_->GetDisplayPoint();
  return {px[0], px[1]};
}

std::pair<Vec3, Vec3> SceneView::line_of_sight(double x_px, double y_px) const {
  const auto at_depth = [&](double depth) {
    renderer_->SetDisplayPoint(x_px, y_px, depth);
    renderer_->DisplayToWorld();
    const double* p = renderer_->GetWorldPoint();
    return Vec3(p[0] / p[3], p[1] / p[3], p[2] / p[3]);
  };
  return {at_depth(0), at_depth(1)};
}

PointedScene SceneView::pointed() const {
  PointedScene pointed;
  pointed.scene = layout_.scene;
  const auto [near_mm, far_mm] = line_of_sight(0, 0);
  pointed.lines = {near_mm, far_mm, line_of_sight(1, 0).first - near_mm, line_of_sight(0, 1).first - near_mm};
  pointed.towards_eye_W = -Vec3(camera()->GetDirectionOfProjection());
  return pointed;
}

}  // namespace fingerpad
