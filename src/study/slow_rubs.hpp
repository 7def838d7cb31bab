#pragma once

#include <string>
#include <vector>

#include "study/profile_fit.hpp"

namespace fingerpad {

/// Why no rub is fast enough to tell slip from stick that gives way again within a few samples, and what to
/// do; empty where some is, or nothing ruptures or slips at all.
///
/// That is so where the finger gives way and yet hardly any slip is seen to end in stick, at speeds below
/// those at which pads are known to slip (v_min of the built-in profile; paper, fig. 9).
std::string slow_rubs_words(const std::vector<TrialEvidence>& trials);

/// Refuses what rests on slip, where no rub is fast enough to see any.
/// @param words  slow_rubs_words
void refuse_slip(const std::string& words, ProfileFit& fit);

}  // namespace fingerpad
