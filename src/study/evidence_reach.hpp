#pragma once

#include <vector>

#include "study/sampling_reach.hpp"

namespace fingerpad {

// How far numbers would move were the evidence taken otherwise. `segments`, `fit` and `point` are those that
// it was taken by.

/// Were friction to rise as a Hertz pad's does where the load falls, n^(-1/3), of which nothing is told where
/// no slip is surely seen: then loads that differ bend a spring, and lengthen it.
NumberReaches moved_by_load(const Measurement& measurement, const std::vector<StickSegments>& segments,
                            const ProfileFit& fit, const FitPoint& point);

/// Were the axes to go with the load by a power that is two deviations more.
/// @pre  fit.axes_exponent is told
NumberReaches moved_by_axes(const Measurement& measurement, const std::vector<StickSegments>& segments,
                            const ProfileFit& fit, const FitPoint& point);

/// Were the drops at ruptures still to show in one sample more than is left out.
NumberReaches moved_by_tail(const Measurement& measurement, std::vector<StickSegments> segments,
                            const ProfileFit& fit, const FitPoint& point);

}  // namespace fingerpad
