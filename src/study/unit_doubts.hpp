#pragma once

#include <string>
#include <vector>

#include "study/file_trials.hpp"
#include "study/measurement_format.hpp"

namespace fingerpad {

/// What is not a finger's of a file's trials.
struct UnitDoubt {
  bool is_refused = false;  ///< and its unit was not said
  std::string words;
  bool is_of_times = false;
};

/// Of times, torques, positions and forces, in that order.
/// @param format       with the units said that the file's own table tells
/// @param tells_times  the table tells that of its times, against which none can be said
std::vector<UnitDoubt> unit_doubts(FileTrials trials, const MeasurementFormat& format, bool tells_times);

}  // namespace fingerpad
