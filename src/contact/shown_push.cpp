#include "contact/shown_push.hpp"

#include <algorithm>
#include <cmath>

#include "contact/proxy_leash.hpp"
#include "contact/proxy_limits.hpp"
#include "contact/turn.hpp"

namespace fingerpad {
namespace {

/// As far on the way from the last tick's normal to another as changes the push by at most so much.
/// @pre the other changes it by more
Vec3 normal_towards(const Vec3& shaded_W, double most_m, const ProxyState& state) noexcept {
  const double depth_m = state.contact.depth_m, last_m = state.last_push_W.norm();
  const Vec3 last = state.last_push_W / last_m, across = shaded_W - shaded_W.dot(last) * last;
  const double across_m = across.norm();
  if (!(across_m > ProxyLimits::least_turn_sine)) return shaded_W;
  // The law of cosines in the triangle of both pushes and their difference.
  const double cosine =
      std::min(1.0, (depth_m * depth_m + last_m * last_m - most_m * most_m) / (2 * depth_m * last_m));
  return cosine * last + std::sqrt(std::max(0.0, 1 - cosine * cosine)) / across_m * across;
}

/// Shows a hop that is felt over several ticks: as much of it as a tick may.
void show_part_of_hop(const Vec3& shaded_W, double most_m, ProxyState& state) noexcept {
  ProxyContact& contact = state.contact;
  state.lags = true;
  contact.normal_W = normal_towards(shaded_W, most_m, state);
  // A hop that had to wait can bring the proxy nearer by more than may be shown at once.
  const double held_back_m = state.last_push_W.norm() - most_m - contact.depth_m;
  contact.depth_m += std::max(0.0, held_back_m);
}

/// Shows as much of a turn that jumps as a tick may.
void show_part_of_turn(const Vec3& shaded_W, double step2_m2, double most_m, ProxyState& state) noexcept {
  const Vec3& direction = state.contact.direction_W;
  const double depth_m = state.contact.depth_m;
  // The last turn, kept, changes the push by no more than the way to the proxy changes.
  const Vec3 last = turn_between(state.last_direction_W, state.last_push_W.normalized());
  const Vec3 left = turn_between(direction, shaded_W) - last;
  const Vec3 kept = turned(direction, last);
  const double kept_step_m = (depth_m * kept - state.last_push_W).norm();
  if (kept_step_m * kept_step_m > step2_m2) return;
  // A unit vector goes by no more than twice what its turn changes by.
  const double left_m = 2 * depth_m * left.norm(), room_m = std::max(0.0, most_m - kept_step_m);
  if (room_m < left_m) state.contact.normal_W = turned(direction, last + room_m / left_m * left);
}

}  // namespace

void show_push(const ProxyWorld& world, const Vec3& shaded_W, ProxyState& state) noexcept {
  state.contact.normal_W = shaded_W;
  const bool after_hop = state.hopped || state.lags;
  state.lags = false;
  if (!world.is_shaded() || state.last_push_W.isZero(0)) return;
  const double depth_m = state.contact.depth_m;
  const double step2_m2 = (depth_m * shaded_W - state.last_push_W).squaredNorm();
  if (step2_m2 <= state.finger_m * state.finger_m) return;
  const double most_m =
      most_step_m(state, state.last_push_W.norm()) + (after_hop ? ProxyLimits::unfelt_share * depth_m : 0.0);
  if (step2_m2 <= most_m * most_m) return;
  if (after_hop) {
    show_part_of_hop(shaded_W, most_m, state);
  } else {
    show_part_of_turn(shaded_W, step2_m2, most_m, state);
  }
}

}  // namespace fingerpad
