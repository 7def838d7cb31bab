#pragma once

#include "study/profile_fit.hpp"

namespace fingerpad {

/// Tells the normal law of a fit by the presses of all trials, those too of which the normal force alone was
/// measured: its numbers, intervals, outlying trials and doubts, and how many trials and subjects the fit now
/// rests on. What is told of friction stays as it is. The force's zero, where no tare was taken off, is
/// allowed for by a tenth of a newton; a delay that is not told as in fit_profile.
void take_normal_law(const Measurement& measurement, const FitSettings& settings, ProfileFit& fit);

}  // namespace fingerpad
