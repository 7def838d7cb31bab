#pragma once

#include <string>
#include <vector>

#include "study/file_trials.hpp"

namespace fingerpad {

/// What of one trial is not as the others of its measurement have it, a line a doubt that begins with the
/// trial's name: a normal force that is fifty times theirs or more, or as much less, as of another unit;
/// positions that reach 300 times as far, or as much less, or over half a metre and 20 times; a press, or
/// friction, of the other sign. Others are the more, and of as many those that are more like a finger's. Of
/// fewer than three trials no friction's sign is odd.
std::vector<std::string> odd_trial_doubts(const std::vector<RecordedTrial>& trials);

/// Leaves out the trials whose press is of the other sign, which odd_trial_doubts names: what they tell in
/// the air by chance would count as a touch.
void leave_out_turned_presses(RecordedMeasurement& recorded);

}  // namespace fingerpad
