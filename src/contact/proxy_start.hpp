#pragma once

#include <optional>

#include "contact/proxy_world.hpp"

namespace fingerpad {

/// Where a ball that appears at `goal_O` may stand: there if nothing comes nearer than the clearance, else
/// the nearest surface point outwards, moved on where another surface is in the way. Inside of a part is
/// where the nearest feature's pseudonormal says so and the winding number about the point is above one half:
/// not merely behind an open sheet, and not outside a shell that is wound inside out. Nothing where no such
/// place was found within a bounded search (a slot narrower than the ball). Among planes alone: the nearest
/// place that is clear of all of them.
/// @param goal_O  finite
/// noexcept, allocates nothing. O(triangles) where the goal is behind a surface.
std::optional<Vec3> proxy_start(const ProxyWorld& world, const Vec3& goal_O) noexcept;

}  // namespace fingerpad
