#pragma once

#include "contact/proxy_state.hpp"
#include "contact/proxy_world.hpp"

namespace fingerpad {

/// Shows the finger a normal, or, where the push (depth_m along normal_W) would change by more than the way
/// to the proxy may in a tick (most_step_m), one on the way there from the last tick's.
///
/// A turn that jumps, as walls come and go, follows as fast as that leaves room for, and until then is at
/// most as wide as it was. A hop that would change the push by more is shown over as many ticks as that
/// takes, and the next hop waits for it (state.lags).
/// @pre state.contact has the tick's depth and direction
void show_normal(const ProxyWorld& world, const Vec3& shaded_W, ProxyState& state) noexcept;

}  // namespace fingerpad
