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
/// would hold are too short for their samples at the speeds at which it slips (slip_may_hold_teeth).
std::string unseen_slip_words(const std::vector<TrialEvidence>& trials, const PadValues& found,
                              const FitPoint& point);

/// Where one look says so and the next does not.
inline constexpr const char* hardly_seen_slip =
    "no slip is surely seen: whether what passes for it is teeth of stick and slip is at the edge of what "
    "can be "
    "told: rub faster, or sample faster";

/// Whether the teeth that slip would hold, which drop by twice what its friction lies below mu_static, are
/// too short to be seen at its speeds; so too where a coefficient or the springs are not told.
bool slip_may_hold_teeth(const std::vector<TrialEvidence>& trials, const PadValues& found);

}  // namespace fingerpad
