#pragma once

#include "base/types.hpp"

namespace fingerpad {

/// A box along the axes [m].
struct Bounds {
  Vec3 min = Vec3::Zero(), max = Vec3::Zero();
};

}  // namespace fingerpad
