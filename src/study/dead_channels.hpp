#pragma once

#include <string>
#include <vector>

#include "study/file_trials.hpp"

namespace fingerpad {

/// What to tell of each trial whose force along the plate is the same in every sample though the finger
/// presses: a sensor's channels that are not connected, or columns that nothing was written into.
std::vector<std::string> dead_channel_doubts(FileTrials own, const std::vector<RecordedTrial>& all);

}  // namespace fingerpad
