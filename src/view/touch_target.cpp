#include "view/touch_target.hpp"

#include <algorithm>
#include <cmath>

#include "touch/finger_room.hpp"
#include "touch/parts_ball.hpp"
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
  on_rim_ = false;
}

void TouchTarget::point_at_rim(const Vec3& point_W, const Vec3& normal_W, int surface) {
  point_at(point_W, normal_W, surface);
  on_rim_ = true;
}

void TouchTarget::move_by(const Vec3& step_W, const Vec3& towards_eye_W, const Vec3& finger_W) {
  if (surface_ < 0) {
    spot_W_ += step_W;
    return;
  }
  on_rim_ = false;
  if (radius_m_ > 0) rest_at(begin_roll_W(towards_eye_W, finger_W), 2 * radius_m_);
  const Vec3 along_W = step_W - step_W.dot(normal_W_) * normal_W_;
  const double reach_m = radius_m_ + 10 * step_W.norm() + hover_m_;
  if (!rest_at(spot_W_ + radius_m_ * normal_W_ + along_W, reach_m)) spot_W_ += along_W;
}

/// The centre of the ball that rolls.
Vec3 TouchTarget::begin_roll_W(const Vec3& towards_eye_W, const Vec3& finger_W) const noexcept {
  constexpr double has_room_share = 0.9, hardly_share = 1e-3, near_share = 3;
  const Vec3 centre_W = spot_W_ + radius_m_ * normal_W_;
  Looks looks(Looks::unlimited);
  const double clear_m = nearest_surface(*world_, centre_W, Normals::facet, radius_m_, looks).clear_m;
  if (clear_m >= has_room_share * radius_m_) return centre_W;
  if ((finger_W - spot_W_).norm() < near_share * radius_m_) return finger_W;
  const auto parts = ball_of_parts(*world_);
  const double parts_m = parts ? (parts->centre_W - spot_W_).dot(towards_eye_W) + parts->radius_m : 0;
  return stopped_on_line(*world_, spot_W_, towards_eye_W, std::max(0.0, parts_m) + 2 * radius_m_, radius_m_,
                         hardly_share * radius_m_, looks);
}

/// Onto the surface from this centre of the ball, and out of other walls.
/// @returns false, and nothing changed, where no surface is within reach
bool TouchTarget::rest_at(Vec3 centre_W, double reach_m) noexcept {
  constexpr int most_turns = 8;
  constexpr double hardly_share = 1e-3;
  Looks looks(Looks::unlimited);
  for (int i = 0; i < most_turns; ++i) {
    const NearestSurface nearest = nearest_surface(*world_, centre_W, normals_, reach_m, looks);
    if (nearest.surface < 0) return i > 0;
    const Vec3 out_W = centre_W - nearest.at.point_W;
    // The ball's own radius is the way out, round an edge too. A centre that is on the surface tells none.
    const bool tells = nearest.clear_m > hardly_share * radius_m_ && radius_m_ > 0;
    spot_W_ = nearest.at.point_W;
    normal_W_ = tells ? out_W.normalized() : nearest.at.normal_W;
    surface_ = nearest.surface;
    const Vec3 rests_W = spot_W_ + radius_m_ * normal_W_;
    if ((rests_W - centre_W).norm() <= hardly_share * radius_m_) break;
    centre_W = rests_W;
  }
  return true;
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
  if (on_rim_) return true;
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
