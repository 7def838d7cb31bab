#pragma once

#include <string>
#include <vector>

#include "study/file_trials.hpp"

namespace fingerpad {

/// What of one trial is not as its file's others have it, a line a doubt, "FILE, subject 1, trial 3: ...": a
/// normal force that is fifty times theirs or more, or as much less, as of another unit; a press, or
/// friction, of the other sign. Of fewer than three trials none is odd.
std::vector<std::string> odd_trial_doubts(FileTrials trials);

/// Leaves out the trials whose press is of the other sign, which odd_trial_doubts names: what they tell in
/// the air by chance would count as a touch.
void leave_out_turned_presses(RecordedMeasurement& recorded);

}  // namespace fingerpad
