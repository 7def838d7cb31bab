#pragma once

#include <memory>
#include <vector>

#include "study/stretch_run.hpp"

namespace fingerpad {

/// How much of a motion is compared, and in how many stretches where it is longer [s].
inline constexpr double compared_s = 15;
inline constexpr int stretch_count = 10;

/// What of a scene's motion choices are compared over: all of it, or, where it lasts longer than compared_s,
/// so much of it in stretches. Each is drawn with the scene's seed from its own tenth of the motion, and is
/// begun at the last moment before it at which the finger was free, if there is one within two seconds, else
/// half a second before it.
/// @param path  of the scene
std::vector<MotionStretch> motion_stretches(const std::shared_ptr<const World>& world, const Scene& scene,
                                            const FingerPath& path);

}  // namespace fingerpad
