#pragma once

#include "motion/stable_stiffness.hpp"

namespace fingerpad {

/// exact_stable_stiffness found by touching: a simulated hand in the closed loop on a plane, its ringing
/// watched, the stiffness bisected to 0.2 %. With a quantum, stable means that the motion comes to rest
/// within one.
double measured_stable_stiffness(const HeldWall& wall);

}  // namespace fingerpad
