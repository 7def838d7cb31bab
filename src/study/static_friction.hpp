#pragma once

#include <string>
#include <vector>

#include "study/pad_numbers.hpp"

namespace fingerpad {

/// mu_static: the mean of the subjects' means of |q| at ruptures.
///
/// Where trials of one subject are unlike one another, those whose ruptures are counted may not stand for
/// all: slippery ones rupture more often. Then each subject's is what its ruptures are over the slip of the
/// same trials, times what all its trials slip by.
/// @param is_paired  by each trial's own slip: FitPoint::pairs_friction
PadValue static_friction(const std::vector<TrialEvidence>& trials, const std::vector<int>& times,
                         bool is_paired);

/// Whether by each trial's own slip it is another, by more than a twentieth.
bool is_friction_unlike(const std::vector<TrialEvidence>& trials);

/// Each subject's own friction, of the trials whose ruptures are counted; 0 where none are. What one pad
/// slips by may be more than what another sticks by.
std::vector<OwnFriction> own_frictions(const std::vector<TrialEvidence>& trials);

/// Whether mu_static is below mu_dynamic, which no pad's is.
bool contradicts_law(const PadValues& found);

/// Which two trials of one subject differ most in what they slip by, and what may be why; empty where none
/// differ by so many times.
std::string unlike_trials_words(const std::vector<std::string>& names,
                                const std::vector<TrialEvidence>& trials, double least_times);

}  // namespace fingerpad
