#pragma once

#include <vector>

#include "study/pad_numbers.hpp"

namespace fingerpad {

/// What the next pass is to be taken about.
FitPoint next_point(const std::vector<TrialEvidence>& trials, const FitPoint& point);

/// Leaves the coefficients as they were measured where what passes for slip may be teeth: how those change
/// with the load is no exponent of friction. They hold at the ruptures' load then, where there are any.
void doubt_slip(const std::vector<TrialEvidence>& trials, FitPoint& point);
/// Takes that back.
void trust_slip(FitPoint& point);

}  // namespace fingerpad
