#pragma once

#include <span>

namespace fingerpad {

/// The median of the forces of samples that press one way or the other: beyond a quarter of what 99 % of all
/// stay within, so that neither a spike nor a finger in the air decides. Its sign tells on what they act: of
/// forces on the finger, along the surface's normal, it is above 0.
/// @pre forces are not empty
double pressed_median_n(std::span<const double> force_n);

/// A normal force as that which presses the finger: one on the surface, which is below 0 where it presses, is
/// turned round.
void turn_to_finger(std::span<double> normal_force_n);

}  // namespace fingerpad
