#pragma once

#include <vector>

#include "study/profile_fit.hpp"
#include "study/sampling_reach.hpp"

namespace fingerpad {

/// Gives each number of a fit that is told its interval, as fit_profile says, or why it has none.
/// @param subject_of  of each trial of fit.evidence
/// @param by_delay    how far the delay moves each, and what else is not known of all trials
void add_intervals(const std::vector<int>& subject_of, const NumberReaches& by_delay,
                   const FitSettings& settings, FitPoint point, ProfileFit& fit);

}  // namespace fingerpad
