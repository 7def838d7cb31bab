#pragma once

#include <string>

#include "replay/nearest_approach.hpp"
#include "scene/scene.hpp"

namespace fingerpad {

/// What to say of a motion that has touched nothing: how near it came to what, and both sizes, by which a
/// mistaken unit is seen. Empty where it was not outside of everything.
/// @param is_placed  the motion was turned or moved into the world: what its columns would be otherwise is
/// then not asked
std::string never_touches(const World& world, const FingerPath& path, double radius_m,
                          bool is_placed = false);
/// The same where it is known already how near it came.
std::string never_touches(const World& world, const FingerPath& path, const NearestApproach& nearest,
                          double radius_m, bool is_placed);

/// What to say of a recording that presses the finger in so deep as no finger is: its unit is likely
/// another. Empty of scripted motions, and of depths that may be.
std::string pressed_too_deep(const Scene& scene, double depth_m);

}  // namespace fingerpad
