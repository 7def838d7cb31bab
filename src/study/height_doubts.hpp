#pragma once

#include <string>
#include <vector>

#include "study/file_trials.hpp"

namespace fingerpad {

/// What is odd in how high fingers are: one that presses is lower than it was in the air, but where its
/// height is mirrored. Of a file most of whose trials are so, a line on the file; else one on each trial.
/// Trials without air tell nothing.
/// @param all  of all files, among which a trial is named
std::vector<std::string> height_doubts(FileTrials own, const std::vector<RecordedTrial>& all);

}  // namespace fingerpad
