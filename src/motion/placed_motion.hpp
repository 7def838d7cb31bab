#pragma once

#include "motion/motion.hpp"
#include "motion/scripted_motion.hpp"

namespace fingerpad {

/// Turns and moves a motion: all that it says of places, directions, velocities and pushes.
/// @param rotation, position_m  of the motion's own coordinates in the world
void place(Motion& motion, const Mat3& rotation, const Vec3& position_m);
void place(ScriptedMotion& motion, const Mat3& rotation, const Vec3& position_m);

}  // namespace fingerpad
