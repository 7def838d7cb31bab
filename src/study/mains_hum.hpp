#pragma once

#include <array>
#include <vector>

#include "study/cleaning_settings.hpp"
#include "study/hann_line.hpp"

namespace fingerpad {

/// What was taken off of mains hum.
struct MainsHum {
  double frequency_hz = 0;  ///< 0: nothing was
  double amplitude = 0;     ///< the greatest of the axes [N], of torques [N m]
};

/// A line that stands out of a trial's spectrum near a frequency of the mains.
struct HumLine {
  double nominal_hz = 0, hz = 0;
  std::array<bool, 3> hums{};      ///< the axes it stands on
  Phasors phasors{};               ///< at sample 0
  std::array<double, 3> around{};  ///< mean power of the axes beside it
  bool is_of_air = false;          ///< told by moments in the air alone: what else is there is none of it

  /// The greatest of the axes.
  double amplitude() const;
};

/// Whether a line near a frequency of the mains would be seen in what a trial sensed: there is some, it is at
/// least 1 s long, and its rate is above twice the line's.
bool can_show_line(const RecordedTrial& trial, Sensed sensed, double nominal_hz);

/// On each axis the sine of constant amplitude and phase that stands out of the spectrum (Hann window over
/// the whole trial) twelvefold in power, near 50 or 60 Hz. Whether it is hum, judge_hum says.
std::vector<HumLine> hum_lines(const RecordedTrial& trial, Sensed sensed, Mains mains);

/// Whether the finger's position has the line too: it vibrates, or its tracker hums.
bool position_has(const HumLine& line, const RecordedTrial& trial);

/// Takes lines out of what was sensed. What does not keep its phase, as a vibration of the pad at that
/// frequency, stays.
MainsHum take_off(const std::vector<HumLine>& lines, Sensed sensed, RecordedTrial& trial);

}  // namespace fingerpad
