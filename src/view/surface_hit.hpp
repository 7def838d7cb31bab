#pragma once

#include "base/types.hpp"

namespace fingerpad {

/// Where a line of sight meets a surface of the world.
struct SurfaceHit {
  Vec3 point_W = Vec3::Zero();
  Vec3 normal_W = Vec3::UnitZ();  ///< unit, outward
  int surface = -1;
  double along = 0;  ///< 0 at the line's start, 1 at its end
};

}  // namespace fingerpad
