#include "device/open_place.hpp"

#include <algorithm>
#include <cmath>

#include "device/pointer_limits.hpp"
#include "touch/finger_room.hpp"

namespace fingerpad {
namespace {

/// So much room is none [of what a flight keeps from the parts].
constexpr double hardly_share = 0.1;

}  // namespace

void OpenPlace::aim(const PointerAim& aim) noexcept {
  const bool same = has_aim_ && aim.finger.p_WQ == aim_.finger.p_WQ && aim.spot_W == aim_.spot_W &&
                    aim.finger.push_W_n == aim_.finger.push_W_n && aim.towards_eye_W == aim_.towards_eye_W;
  if (same && has_looked_) return look_on();
  aim_ = aim;
  has_aim_ = has_looked_ = true;
  if (given_up_ && !is_given_up()) given_up_.reset();
  look();
}

void OpenPlace::give_up() noexcept {
  given_up_ = aim_;
  has_looked_ = false;
}

bool OpenPlace::is_given_up() const noexcept {
  constexpr double beside = 2;
  return given_up_ &&
         (aim_.towards_eye_W - given_up_->towards_eye_W).norm() <= pointer_limits::another_view &&
         (aim_.spot_W - given_up_->spot_W).norm() < beside * soft_m_;
}

void OpenPlace::look() noexcept {
  const double radius_m = around_.finger_radius_m();
  // So far a finger goes into coarse facets, and two walls hold it off no farther than it counts as there.
  constexpr double tolerated_share = 0.15;
  const double tolerated_m = std::min(soft_m_, tolerated_share * radius_m);
  const double push_n = aim_.finger.push_W_n.norm();
  // One that hovers goes as near as it can: it need not come down on anything.
  Looks looks(room_looks);
  has_room_ = !given_up_ && (push_n == 0 || seems_free(radius_m - tolerated_m, looks));
  place_W_ = has_room_ ? aim_.finger.p_WQ : stopped_W(looks);
  down_W_ = has_room_ && push_n > 0 ? Vec3(aim_.finger.push_W_n / push_n) : Vec3(-aim_.towards_eye_W);
}

/// Whether there is so much room at the place that was asked for. Where the looks do not tell, there is: what
/// is met on the way there stops the finger all the same.
bool OpenPlace::seems_free(double least_m, Looks& looks) const noexcept {
  const NearestSurface nearest =
      nearest_surface(world_, aim_.finger.p_WQ, Normals::facet, around_.finger_radius_m(), looks);
  // What a search that was broken off has found is there, but on which side of it the place is, is not sure.
  return (nearest.is_sure ? nearest.clear_m : std::abs(nearest.clear_m)) >= least_m;
}

/// Looked for anew where the spot has gone on by a little: from tick to tick it goes hardly anywhere.
Vec3 OpenPlace::stopped_W(Looks& looks) noexcept {
  constexpr double little_share = 0.1;
  const Vec3& eye_W = aim_.towards_eye_W;
  const bool is_near = has_stopped_ && eye_W == stopped_by_W_ &&
                       (aim_.spot_W - stopped_for_W_).norm() < little_share * soft_m_;
  if (is_near) return stopped_at_W_;
  has_stopped_ = true;
  stopped_by_W_ = eye_W;
  stopped_for_W_ = aim_.spot_W;
  const double radius_m = around_.finger_radius_m();
  const double from_m = (around_.middle_W() - aim_.spot_W).dot(eye_W) + around_.radius_m() + radius_m;
  stopped_at_W_ =
      stopped_on_line(world_, aim_.spot_W, eye_W, from_m, radius_m, hardly_share * soft_m_, looks);
  may_be_lower_ = true;
  return stopped_at_W_;
}

/// Down from where the looks ended, until that leads no lower.
void OpenPlace::look_on() noexcept {
  if (has_room_ || !may_be_lower_) return;
  const double hardly_m = hardly_share * soft_m_, up_m = (stopped_at_W_ - stopped_for_W_).dot(stopped_by_W_);
  Looks looks(room_looks);
  const Vec3 lower_W = stopped_on_line(world_, stopped_for_W_, stopped_by_W_, up_m, around_.finger_radius_m(),
                                       hardly_m, looks);
  may_be_lower_ = (stopped_at_W_ - lower_W).norm() > hardly_m;
  if (may_be_lower_) place_W_ = stopped_at_W_ = lower_W;
}

Vec3 OpenPlace::place_below_W(const Vec3& finger_W) const noexcept {
  if (has_room_) return place_W_;
  const double most_m = (aim_.spot_W - place_W_).dot(down_W_), gone_m = (finger_W - place_W_).dot(down_W_);
  return place_W_ + std::clamp(gone_m, 0.0, std::max(0.0, most_m)) * down_W_;
}

double OpenPlace::gain_m(const Vec3& finger_W) const noexcept {
  if (has_room_) return (place_W_ - finger_W).norm();
  return std::max(0.0, (finger_W - aim_.spot_W).norm() - (place_W_ - aim_.spot_W).norm());
}

}  // namespace fingerpad
