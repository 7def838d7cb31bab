#pragma once

#include <vector>

#include "study/sampling_reach.hpp"

namespace fingerpad {

/// How far the numbers that rest on stick (spring_numbers) may be off by chance within the trials: 95 % of
/// the jackknife over ten parts of their stick. What trials differ by comes on top, which few of them do not
/// tell. Infinite where stick is too little for ten parts, or a number is refused without one of them; 0 for
/// all others.
NumberReaches reach_by_stretches(const Measurement& measurement, const std::vector<StickSegments>& segments,
                                 const ProfileFit& fit, const FitPoint& point);

}  // namespace fingerpad
