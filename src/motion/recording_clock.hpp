#pragma once

#include <span>
#include <string>

namespace fingerpad {

/// The clock of a recording, as its times tell it.
struct RecordingClock {
  /// Its own rate [Hz]: of the mean of the steps that are like their median, which neither gaps nor the
  /// rounding of times move; in as few digits as the times themselves are sure of. 0: one sample has none.
  double rate_hz = 0;
  double shortest_s = 0, longest_s = 0;  ///< steps
  double longest_at_s = 0;               ///< when the longest begins
  long steps = 0;
  long odd_steps = 0;  ///< that differ from the rate's by more than half: samples that are missing or bunched

  /// Whether every sample is within a millionth of a step of where the rate has it.
  bool is_even = false;
};

/// @param t_s  increasing
RecordingClock recording_clock(std::span<const double> t_s);

/// "240 Hz (median of 1199 steps, from 4.1 to 4.2 ms)".
std::string clock_text(const RecordingClock& clock);

}  // namespace fingerpad
