#pragma once

#include <optional>

#include "base/types.hpp"

namespace fingerpad {

struct Surface;

/// Where a line of sight meets a surface of the world.
struct SurfaceHit {
  Vec3 point_W = Vec3::Zero();
  Vec3 normal_W = Vec3::UnitZ();  ///< unit, outward
  int surface = -1;
  double along = 0;     ///< 0 at the line's start, 1 at its end
  bool on_rim = false;  ///< under a finger that is too large for what lies beyond
};

/// Where the line from a to b first meets a surface: a part from either side, by the tree that it is touched
/// by, so that nothing is built; a plane from its outside. A part without a tree is not met.
/// @returns with `surface` unset
std::optional<SurfaceHit> line_hit(const Surface& surface, const Vec3& a_W, const Vec3& b_W) noexcept;

}  // namespace fingerpad
