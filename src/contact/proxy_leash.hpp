#pragma once

#include <limits>

#include "contact/proxy_state.hpp"
#include "contact/proxy_world.hpp"

namespace fingerpad {

// How much a proxy's push may change in a tick.
//
// The steps of a tick change the way from the finger to the proxy by at most three times as much as the
// finger went (or, where that is more, by as much as it went and the share dt/0.5 s of the depth), so that a
// finger pressed in deep that slips off an edge is let go within a motion and not within a tick. Round a
// rounding the proxy keeps up while it has at most four times as far to go as the finger, which is as deep as
// three quarters of the rounding's radius and the ball's together.
//
// A first touch may be anything; and so, for `arrival_s`, may what is left of it where its tick's looks ran
// out.
//
// A hop over a smooth edge does not count towards this, since there the facets give way and not the shape;
// the steps after it do. It may add 7 % of the depth, which nobody feels.

/// Where a proxy may go in a tick: within a length of where it would be, had it gone as the finger did. So
/// the push changes by no more than that.
struct ProxyLeash {
  Vec3 centre_O = Vec3::Zero();
  double length_m = std::numeric_limits<double>::infinity();
  double step_m = std::numeric_limits<double>::infinity();  ///< the longest single step

  /// How much of a way by `z` the leash allows, from a place within it: 0 to 1.
  double share_of(const Vec3& place_O, const Vec3& z) const noexcept;
};

/// The leash of a tick in which the finger has gone to state.goal_O; none where it touched nothing before.
/// @param push  from the finger to the proxy, before it went
ProxyLeash leash_after(const Vec3& push, const ProxyWorld& world, const ProxyState& state) noexcept;

/// The largest change in a tick of a push that was so long before it: the finger's motion and the proxy's
/// [m]. Infinite while a first touch has not come to its end.
double most_step_m(const ProxyState& state, double last_m) noexcept;

/// Whether the hops of this tick change the push by more than hops may. A first touch may be anything.
bool are_hops_felt(const ProxyState& state) noexcept;

}  // namespace fingerpad
