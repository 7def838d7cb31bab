#include "contact/proxy_leash.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/proxy_limits.hpp"

namespace fingerpad {

double ProxyLeash::share_of(const Vec3& place_O, const Vec3& z) const noexcept {
  const Vec3 from = place_O - centre_O;
  if (!((from + z).squaredNorm() > length_m * length_m)) return 1;
  // |from + t z| = length, from within it.
  const double a = z.squaredNorm(), b = from.dot(z), c = from.squaredNorm() - length_m * length_m;
  return c < 0 ? std::clamp((std::sqrt(b * b - a * c) - b) / a, 0.0, 1.0) : 0;
}

ProxyLeash leash_after(const Vec3& push, const ProxyWorld& world, const ProxyState& state) noexcept {
  if (!state.contact.touching()) return {};
  // What is shown of it has no skin, and may change by as much more.
  const double most_m = most_step_m(state, push.norm()) - 2 * world.skin_m();
  const double length_m = std::max(most_m, state.finger_m + push.norm() * state.rest_share);
  return {state.goal_O + push, length_m, std::max(length_m - state.finger_m, state.finger_m)};
}

double most_step_m(const ProxyState& state, double last_m) noexcept {
  if (state.arrives_s > 0) return std::numeric_limits<double>::infinity();
  return state.finger_m + std::max(ProxyLimits::proxy_per_finger * state.finger_m, last_m * state.rest_share);
}

bool are_hops_felt(const ProxyState& state) noexcept {
  if (!state.hopped || state.last_push_W.isZero(0)) return false;
  const double last_m = state.last_push_W.norm();
  const Vec3 way = state.place_O - state.goal_O, change = way - last_m * state.last_direction_W;
  return change.norm() > most_step_m(state, last_m) + ProxyLimits::unfelt_share * way.norm();
}

}  // namespace fingerpad
