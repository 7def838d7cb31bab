#pragma once

#include <vector>

#include "study/pad_numbers.hpp"

namespace fingerpad {

/// The centre of the highest peak between 20 Hz and nine tenths of half the rate: the mean frequency within
/// 8 Hz of it, weighted with the density above the median (moved until it stays). Refused where no slip is
/// long enough for a window, rates differ, or no density is three times the median.
PadValue vibration_peak(const std::vector<TrialEvidence>& trials, const std::vector<int>& times);

}  // namespace fingerpad
