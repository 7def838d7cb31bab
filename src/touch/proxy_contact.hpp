#pragma once

#include "contact/proxy.hpp"
#include "touch/world.hpp"

namespace fingerpad {

/// A proxy for a finger of this radius in a whole world: every part in its pose and every plane holds it.
Proxy world_proxy(const World& world, double radius_m, Normals normals);

/// Whether this move put the proxy down anew although the finger was inside of a part, or where the ball
/// does not fit: the first force then comes from a place that the finger has not been at.
bool started_inside(const ProxyContact& contact, const World& world, const Vec3& p_WQ) noexcept;

}  // namespace fingerpad
