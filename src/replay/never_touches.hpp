#pragma once

#include <string>

#include "motion/finger_path.hpp"
#include "touch/world.hpp"

namespace fingerpad {

/// What to say of a motion that has touched nothing: how near it came to what, and both sizes, by which a
/// mistaken unit is seen. Empty where it was not outside of everything.
///
/// Some 2000 places along the path are looked at: the nearest one is as near as their distance.
std::string never_touches(const World& world, const FingerPath& path, double radius_m);

}  // namespace fingerpad
