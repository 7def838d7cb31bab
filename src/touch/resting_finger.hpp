#pragma once

#include "motion/finger_path.hpp"

namespace fingerpad {

struct Scene;
struct World;

/// A finger at rest above what can be touched: where a live touch begins.
FingerSample resting_finger(const World& world, const Scene& scene);

}  // namespace fingerpad
