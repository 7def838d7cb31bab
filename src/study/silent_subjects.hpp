#pragma once

#include "study/measurement.hpp"
#include "study/profile_fit.hpp"

namespace fingerpad {

/// Tells as a step of the fit of whom no rupture is counted where others' are: mu_static and the stick axes
/// are the others' alone.
void tell_silent_subjects(const Measurement& measurement, ProfileFit& fit);

}  // namespace fingerpad
