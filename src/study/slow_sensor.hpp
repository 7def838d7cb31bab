#pragma once

#include <vector>

#include "study/profile_fit.hpp"
#include "study/stick_segments.hpp"

namespace fingerpad {

/// Tells what a force sensor's low pass makes of ruptures: as steps of the fit where it is taken out, as
/// doubts where it is slower than that, or where noise hides it.
/// @param segments  of the trials
void tell_slow_sensor(const std::vector<StickSegments>& segments, const FitPoint& point, ProfileFit& fit);

}  // namespace fingerpad
