#pragma once

#include <vector>

#include "study/profile_fit.hpp"

namespace fingerpad {

/// Tells as a step of the fit which samples are pressed too lightly to tell stick or slip.
void tell_light_samples(const Measurement& measurement, const std::vector<StickSegments>& segments,
                        ProfileFit& fit);

/// Tells as a step of the fit how springs were taken to one load (fit.axes_exponent), or that they were not.
/// @param takes_axes_exponent  FitSettings'
void tell_axes_exponent(bool takes_axes_exponent, ProfileFit& fit);

}  // namespace fingerpad
