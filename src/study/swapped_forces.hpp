#pragma once

#include <string>
#include <vector>

#include "study/file_trials.hpp"

namespace fingerpad {

/// Whether the force along the plate's normal looks like friction and another like the press: the first
/// changes its sign to and fro, which a press never does, and the other does not. Of trials without air
/// nothing is told, as a sensor's offset could be either.
/// @returns why to refuse the file; empty where nothing is odd
std::string swapped_forces_doubt(FileTrials trials);

/// The same of single trials, where they are no more than half of their file: what to tell of each.
std::vector<std::string> swapped_trial_doubts(FileTrials own, const std::vector<RecordedTrial>& all);

}  // namespace fingerpad
