#pragma once

#include <vector>

#include "friction/pad_profile.hpp"
#include "study/stick_segments.hpp"

namespace fingerpad {

struct ProfileFit;

/// A finger pad on a plate, as a scene names it: a profile, and the plate's coefficients.
struct PadOnPlate {
  PadProfile profile;
  double mu_static = 0.3, mu_dynamic = 0.2;
};

/// The program's own where a scene names nothing: k_f = 1000 1/m and a surface's default coefficients.
PadOnPlate built_in_pad();

/// Whether a fit gives enough to run its pad: both coefficients, and axes or a stiffness.
bool is_runnable(const ProfileFit& fit);
/// The pad that a fit has found. Where it has no axes (no finger direction), those that the default ratio and
/// slopes make of its stiffness; v_min as a profile's default where it is refused.
/// @pre is_runnable(fit)
PadOnPlate fitted_pad(const ProfileFit& fit);

/// The tangential force on the finger that the finger-pad law gives along a measured trial, with its measured
/// normal force and the velocity of its segments, at its angle (angle_deg); in the pad's axes [N]. A sample
/// that starts anew begins a contact.
std::vector<Vec2> pad_force_n(const MeasuredTrial& trial, const StickSegments& segments,
                              const PadOnPlate& pad);

}  // namespace fingerpad
