#pragma once

#include <string>
#include <vector>

#include "study/measurement.hpp"

namespace fingerpad {

/// Estimates by how much force lags position in each file, for each was recorded with a device and clocks of
/// its own, and moves the positions by it; then once more, since stick is told better then. Files that do not
/// tell theirs are taken together, as if of one device. A known delay (settings) is taken out instead, and
/// the rest told; with takes_delay off nothing is moved.
/// @returns an entry a file, and one for those taken together
std::vector<FileDelay> settle_delays(std::vector<RecordedTrial>& trials, const CleaningSettings& settings);

/// By how much the delay of a file may be off: half of its interval; 0 where it has none.
double delay_unsure_s(const std::vector<FileDelay>& delays, const std::string& file);

/// What was done about the delay, for people.
std::string delay_text(const std::vector<FileDelay>& delays, const CleaningSettings& settings);

}  // namespace fingerpad
