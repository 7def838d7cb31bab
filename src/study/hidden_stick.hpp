#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/pad_numbers.hpp"

namespace fingerpad {

/// Why stick that gives way again within a few samples, and so passes for slip, makes the speed at which slip
/// is seen to end too low; empty where it does not.
/// @param found  holds the coefficients
std::string hidden_stick_words(const std::vector<TrialEvidence>& trials, const std::vector<int>& times,
                               const std::optional<SpeedStep>& slow_slip, const PadValues& found);

/// Whether slow slip's friction is so much higher that stick may hide in it, of a law like the pad's.
bool is_hidden_stick(const PadValues& found, const SpeedStep& slow);

/// Whether the speed at which friction steps is better founded as v_min than that at which slip is seen to
/// end: the step is sharp, and nothing was seen to end, or slower by 3 % and more than a step's own bin.
bool tells_v_min(const SpeedStep& slow, const PadValue& seen);

/// Whether stick may give way unseen: v_min is refused for it, most ends of stick in slip show no drop of the
/// force, or no slip is seen to end in stick.
bool may_hide_stick(const std::vector<TrialEvidence>& trials, const std::optional<SpeedStep>& slow_slip,
                    const PadValues& found);

}  // namespace fingerpad
