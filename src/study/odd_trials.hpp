#pragma once

#include <string>
#include <vector>

#include "study/file_trials.hpp"

namespace fingerpad {

/// What of one trial is not as its file's others have it, a line a doubt, "FILE, subject 1, trial 3: ...": a
/// normal force that is fifty times theirs or more, or as much less, as of another unit; a press, or
/// friction, of the other sign. Of fewer than three trials none is odd.
std::vector<std::string> odd_trial_doubts(FileTrials trials);

}  // namespace fingerpad
