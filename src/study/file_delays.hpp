#pragma once

#include <string>
#include <vector>

#include "study/measurement.hpp"

namespace fingerpad {

/// Estimates by how much force lags position in each file, for each was recorded with a device and clocks of
/// its own, and once more with it taken out, since stick is told better then; and moves the positions by what
/// both come to. Files that do not tell theirs are taken together, as if of one device; what is not told
/// then, or can hardly be a delay, stays in. A known delay (settings) is taken out instead, and the rest
/// told; with takes_delay off nothing is moved.
/// @returns an entry a file, and one for those taken together
std::vector<FileDelay> settle_delays(std::vector<RecordedTrial>& trials, const CleaningSettings& settings);

/// As far as the filters of position and force sensors delay them, more or less: how far a delay may be off
/// that is not told.
inline constexpr double usual_delay_s = 25e-3;

/// By how much the delay of a file may be off: half of its interval; usual_delay_s where it is not told.
double delay_unsure_s(const std::vector<FileDelay>& delays, const std::string& file);

/// Whether the delay of a file is told (or is of no file).
bool is_delay_told(const std::vector<FileDelay>& delays, const std::string& file);

/// What was done about the delay, for people.
std::string delay_text(const std::vector<FileDelay>& delays, const CleaningSettings& settings);

}  // namespace fingerpad
