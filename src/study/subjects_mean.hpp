#pragma once

#include <string>
#include <vector>

#include "study/pad_numbers.hpp"

namespace fingerpad {

using EvidenceSum = double TrialEvidence::*;
using EvidenceCount = long TrialEvidence::*;

inline constexpr double enough_ruptures = 10;  ///< beyond which they hardly add to a trial's weight

/// The mean of the subjects' means of a sum over its count; refused by these words where no trial has any. A
/// trial's weight grows with its samples up to `enough` and hardly beyond: more of them say the same trial
/// again, and a trial of low mu_s ruptures more often.
PadValue subjects_mean(const std::vector<TrialEvidence>& trials, const std::vector<int>& times,
                       EvidenceSum sum, EvidenceCount count, double enough, const std::string& refusal);

/// mu_dynamic: that of slip.
PadValue slip_mean(const std::vector<TrialEvidence>& trials, const std::vector<int>& times);

}  // namespace fingerpad
