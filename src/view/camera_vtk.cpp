#include "view/camera_vtk.hpp"

#include <vtkCamera.h>
#include <vtkRenderer.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "part/part.hpp"
#include "touch/world.hpp"
#include "view/free_sight.hpp"

namespace fingerpad {
namespace {

/// The ball that the scene's camera frames.
Ball framed(const ViewExtent& extent) {
  if (!extent.parts || !extent.path) {
    Ball ball = extent.everything();
    ball.radius_m *= extent.parts ? 1.0 : 1.5;
    return ball;
  }
  const Ball &parts = *extent.parts, &path = *extent.path;
  const double radius_m = std::clamp(2.4 * path.radius_m, 0.4 * parts.radius_m, parts.radius_m);
  // The nearer the view, the more it is about the path.
  const double share = (parts.radius_m - radius_m) / parts.radius_m;
  return {parts.centre_W + std::min(1.0, 1.4 * share) * (path.centre_W - parts.centre_W), radius_m};
}

constexpr double sight_margin = 1.08;  // of what is to be in sight

/// The corners of all parts' boxes.
std::vector<Vec3> corners_of_parts(const ViewInput& input) {
  std::vector<Vec3> corners;
  if (!input.world) return corners;
  for (const Surface& surface : input.world->surfaces) {
    if (!surface.part) continue;
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3 sign(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
      const Vec3 p_P = surface.part->centre_P + sign.cwiseProduct(surface.part->half_extent);
      corners.push_back(surface.p_WP + surface.R_WP * p_P);
    }
  }
  return corners;
}

/// Half the height that a camera must see to hold all parts, and no more.
double fitting_scale(const Mat3& axes, const ViewInput& input, const Vec3& focus_W, double width_to_height) {
  double scale_m = 0;
  for (const Vec3& corner_W : corners_of_parts(input)) {
    const Vec3 seen = axes * (corner_W - focus_W);
    scale_m = std::max({scale_m, std::abs(seen.y()), std::abs(seen.x()) / width_to_height});
  }
  return sight_margin * scale_m;
}

/// What is seen about a focus [m].
struct SeenBox {
  Vec2 low = Vec2::Constant(HUGE_VAL), high = Vec2::Constant(-HUGE_VAL);
  void take(const Vec3& seen, double about) {
    low = low.cwiseMin(seen.head<2>() - Vec2::Constant(about));
    high = high.cwiseMax(seen.head<2>() + Vec2::Constant(about));
  }
};

/// From what is looked at to the eye: from the contact's outside, somewhat from the side and from above.
Vec3 towards_eye(const Vec3& facing) {
  Vec3 aside(0.45, -0.9, 0);
  if (std::abs(facing.z()) < 0.7) aside = 0.55 * Vec3::UnitZ() + 0.6 * facing.cross(Vec3::UnitZ());
  aside -= aside.dot(facing) * facing;
  return (facing + 0.85 * aside).normalized();
}

}  // namespace

void set_scene_camera(vtkRenderer* renderer, const ViewInput& input, const TickRecord* shown,
                      const ViewExtent& extent, const DrawSpace& space, double width_to_height) {
  const Ball ball = framed(extent);
  const Vec3 focus = space.to_draw(ball.centre_W);
  const Vec3 eye_direction =
      extent.path ? free_sight(input, shown, towards_eye(extent.facing_W)) : extent.facing_W;
  const double reach_mm = 1e3 * (extent.everything().radius_m + ball.radius_m);
  const Vec3 eye = focus + eye_direction * 3 * reach_mm;
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetFocalPoint(focus.data());
  camera->SetPosition(eye.data());
  const Vec3 up = std::abs(eye_direction.z()) < 0.97 ? Vec3::UnitZ() : Vec3::UnitY();
  camera->SetViewUp(up.data());
  camera->OrthogonalizeViewUp();
  double scale_m = ball.radius_m / std::min(1.0, width_to_height);
  if (extent.parts) {
    scale_m =
        std::min(scale_m, fitting_scale(axes_on_screen(renderer), input, ball.centre_W, width_to_height));
  }
  camera->SetParallelScale(1e3 * scale_m);
  renderer->ResetCameraClippingRange();
}

void set_look(vtkRenderer* renderer, const ViewInput& input, const ViewExtent& extent, const DrawSpace& space,
              const LookFrom& look, double width_to_height) {
  const Ball all = extent.everything();
  const Vec3 focus = space.to_draw(all.centre_W);
  const Vec3 eye = focus + look.towards_eye_W * 6e3 * all.radius_m;
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetFocalPoint(focus.data());
  camera->SetPosition(eye.data());
  camera->SetViewUp(look.up_W.data());
  double scale_m = all.radius_m / std::min(1.0, width_to_height);
  if (extent.parts) {
    const double parts_m = fitting_scale(axes_on_screen(renderer), input, all.centre_W, width_to_height);
    if (parts_m > 0) scale_m = std::min(scale_m, parts_m);
  }
  camera->SetParallelScale(1e3 * scale_m / look.zoom);
  renderer->ResetCameraClippingRange();
}

void take_in_finger(vtkRenderer* renderer, const ViewInput& input, const ViewExtent& extent,
                    const DrawSpace& space, const FingerInSight& finger, double width_to_height,
                    double height_px) {
  constexpr double far_off = 30;  // radii of the whole: a part would be a dot
  const Ball all = extent.everything();
  if (!((finger.tip_W - all.centre_W).norm() < far_off * all.radius_m)) return;
  vtkCamera* const camera = renderer->GetActiveCamera();
  const Mat3 axes = axes_on_screen(renderer);
  SeenBox parts;
  for (const Vec3& corner_W : corners_of_parts(input)) parts.take(axes * (corner_W - all.centre_W), 0);
  if (!extent.parts) parts.take(Vec3::Zero(), all.radius_m);
  const Vec3 tip = axes * (finger.tip_W - all.centre_W), back = axes * finger.back_W;
  double scale_m = 1e-3 * camera->GetParallelScale();
  SeenBox whole;
  // The nearer the view, the shorter is what is as long as the view makes it.
  constexpr int rounds = 8;
  for (int round = 0; round < rounds; ++round) {
    whole = parts;
    whole.take(tip, finger.radius_m);
    const double length_m = std::max(finger.length_m, finger.length_px * 2 * scale_m / height_px);
    whole.take(tip + length_m * back, finger.radius_m);
    const Vec2 half = (whole.high - whole.low) / 2;
    scale_m = sight_margin * std::max(half.y(), half.x() / width_to_height);
  }
  const Vec2 middle = (whole.low + whole.high) / 2;
  const Vec3 aside = 1e3 * (axes.row(0) * middle.x() + axes.row(1) * middle.y()).transpose();
  const Vec3 focus = space.to_draw(all.centre_W) + aside, eye = Vec3(camera->GetPosition()) + aside;
  camera->SetFocalPoint(focus.data());
  camera->SetPosition(eye.data());
  camera->SetParallelScale(1e3 * scale_m);
  renderer->ResetCameraClippingRange();
}

void set_close_up_camera(vtkRenderer* renderer, const Vec3& contact_mm, const Mat3& frame,
                         double half_height_mm) {
  vtkCamera* camera = renderer->GetActiveCamera();
  const Vec3 eye = contact_mm + frame.col(2) * 6 * half_height_mm;
  camera->ParallelProjectionOn();
  camera->SetFocalPoint(contact_mm.data());
  camera->SetPosition(eye.data());
  camera->SetViewUp(frame.col(1).data());
  camera->SetParallelScale(half_height_mm);
  camera->SetClippingRange(0.5 * half_height_mm, 14 * half_height_mm);
}

std::vector<double> view_of(vtkCamera* camera) {
  std::vector<double> view = {camera->GetParallelScale()};
  for (const double* vector : {camera->GetPosition(), camera->GetFocalPoint(), camera->GetViewUp()})
    view.insert(view.end(), vector, vector + 3);
  return view;
}

Mat3 axes_on_screen(vtkRenderer* renderer) {
  vtkCamera* camera = renderer->GetActiveCamera();
  const Vec3 up = Vec3(camera->GetViewUp()).normalized();
  const Vec3 back = -Vec3(camera->GetDirectionOfProjection());
  Mat3 rows;
  rows.row(0) = up.cross(back);
  rows.row(1) = back.cross(up.cross(back));
  rows.row(2) = back;
  return rows;
}

}  // namespace fingerpad
