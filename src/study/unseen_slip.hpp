#pragma once

#include <string>
#include <vector>

#include "study/pad_numbers.hpp"

namespace fingerpad {

/// Why no slip is surely seen, and what to do; empty where some is, or too little gives way to tell.
///
/// Below v_min a finger sticks again as soon as it gives way. Slip is seen where it ends in stick, or where
/// friction falls above some speed. Else what passes for slip may be teeth of stick and slip: where teeth are
/// seen in it, where ruptures are not (their teeth are not seen at any speed), or where the teeth that it
/// would hold, which drop by twice what slip's friction lies below mu_static, are too short for their samples
/// at the speeds at which it slips.
std::string unseen_slip_words(const std::vector<TrialEvidence>& trials, const PadValues& found,
                              const FitPoint& point);

}  // namespace fingerpad
