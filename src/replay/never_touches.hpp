#pragma once

#include <string>

#include "motion/finger_path.hpp"
#include "touch/world.hpp"

namespace fingerpad {

/// What to say of a motion that has touched nothing: how near it came to what, and both sizes, by which a
/// mistaken unit is seen. Empty where it was not outside of everything.
///
/// Some 2000 places along the path are looked at: the nearest one is as near as their distance.
/// @param is_placed  the motion was turned or moved into the world: what its columns would be otherwise is
/// then not asked
std::string never_touches(const World& world, const FingerPath& path, double radius_m,
                          bool is_placed = false);

}  // namespace fingerpad
