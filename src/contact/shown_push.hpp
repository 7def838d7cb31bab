#pragma once

#include "contact/proxy_state.hpp"
#include "contact/proxy_world.hpp"

namespace fingerpad {

/// Shows the finger the push of the tick: its depth along a shaded normal (contact.depth_m, normal_W). Where
/// that would change by more than the way to the proxy may in a tick (most_step_m), what is shown is on the
/// way there from the last tick's.
///
/// A turn that jumps, as walls come and go, follows as fast as that leaves room for, and until then is at
/// most as wide as it was. A hop that would change the push by more is shown over as many ticks as that
/// takes, its depth too, and the next hop waits for it (state.lags).
/// @pre state.contact has the tick's depth and direction
void show_push(const ProxyWorld& world, const Vec3& shaded_W, ProxyState& state) noexcept;

}  // namespace fingerpad
