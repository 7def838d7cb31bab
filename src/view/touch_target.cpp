#include "view/touch_target.hpp"

#include <algorithm>
#include <cmath>

#include "contact/placed_surface.hpp"
#include "view/touch_doubts.hpp"

namespace fingerpad {

TouchTarget::TouchTarget(std::shared_ptr<const World> world, const Scene& scene, double hover_m,
                         const FingerSample& start)
    : world_(std::move(world)),
      normals_(scene.contact.normals),
      radius_m_(scene.finger.radius_m),
      hover_m_(hover_m),
      direction_W_(start.direction_W),
      spot_W_(start.p_WQ),
      most_n_(std::min(20.0, scene.contact.greatest_force_n)),
      least_n_(std::min(0.05, most_n_)),
      press_n_(std::min(1.0, most_n_)) {}

void TouchTarget::point_at(const Vec3& point_W, const Vec3& normal_W, int surface) {
  spot_W_ = point_W;
  normal_W_ = normal_W;
  surface_ = surface;
  seed_ = -1;
}

void TouchTarget::move_by(const Vec3& step_W) {
  if (surface_ < 0) {
    spot_W_ += step_W;
    return;
  }
  const Surface& surface = world_->surfaces[static_cast<std::size_t>(surface_)];
  const Vec3 along_W = step_W - step_W.dot(normal_W_) * normal_W_;
  spot_W_ += along_W;
  if (surface.part && !surface.tree) return;
  const WorldPoint at = nearest_point(surface, spot_W_, normals_, seed_, 10 * step_W.norm() + hover_m_);
  if (!at.found) return;
  spot_W_ = at.point_W;
  normal_W_ = at.normal_W;
  seed_ = at.triangle;
}

void TouchTarget::change_force(int steps) {
  press_n_ = std::clamp(press_n_ * std::pow(1.25, steps), least_n_, most_n_);
}

FingerSample TouchTarget::sample() const {
  FingerSample finger;
  finger.direction_W = direction_W_;
  finger.p_WQ = spot_W_;
  if (surface_ < 0) return finger;
  finger.p_WQ += normal_W_ * (radius_m_ + (pressing_ ? 0.0 : hover_m_));
  if (pressing_) finger.push_W_n = -press_n_ * normal_W_;
  return finger;
}

bool TouchTarget::is_kept_from_spot(const Vec3& finger_W) const {
  // In a corner of two walls a ball stays 0.41 of its radius away.
  constexpr double well_away_share = 0.5;
  if (surface_ < 0) return false;
  const double touching_m = radius_m_ + (pressing_ ? 0 : hover_m_);
  return (finger_W - spot_W_).norm() > touching_m + well_away_share * radius_m_ &&
         is_too_large_for(*world_, spot_W_, normal_W_, radius_m_);
}

Vec3 TouchTarget::pressed_W() const {
  const FingerSample finger = sample();
  if (surface_ < 0) return finger.p_WQ;
  const SurfaceProperties& properties = world_->surfaces[static_cast<std::size_t>(surface_)].properties;
  return finger.p_WQ + finger.push_W_n / properties.stiffness_n_per_m;
}

}  // namespace fingerpad
