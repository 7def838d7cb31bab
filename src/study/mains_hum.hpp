#pragma once

#include <string>
#include <vector>

#include "study/cleaning_settings.hpp"
#include "study/hann_line.hpp"

namespace fingerpad {

/// What was found of mains hum in a trial's forces.
struct MainsHum {
  double frequency_hz = 0;  ///< 0: none stands out
  double amplitude_n = 0;   ///< the greatest of the axes
};

/// A line that stands out of a trial's spectrum near a frequency of the mains.
struct HumLine {
  double nominal_hz = 0, hz = 0;
  std::array<bool, 3> hums{};  ///< the axes it stands on
  Phasors phasors{};
};

/// On each axis the sine of constant amplitude and phase that stands out of the spectrum (Hann window over
/// the whole trial) twelvefold in power, near 50 or 60 Hz.
std::vector<HumLine> hum_lines(const RecordedTrial& trial, Mains mains);

/// Takes lines out of a trial's forces. What does not keep its phase, as a vibration of the pad at that
/// frequency, stays.
MainsHum take_off(const std::vector<HumLine>& lines, RecordedTrial& trial);

/// The lines near 50 or 60 Hz of a measurement's trials that are hum; and in words those that are not. Teeth
/// of stick and slip make such lines too, where a finger moves evenly. Hum stands at one frequency in most
/// trials, and where nothing touches the sensor; if no moment without contact is seen, it keeps its amplitude
/// and phase early and late, and while the finger moves slowly and fast.
struct HumVerdict {
  std::vector<std::vector<HumLine>> lines;  ///< of each trial, to be taken off
  std::string left_in;                      ///< why others are not; empty where there are none
};
HumVerdict judge_hum(const std::vector<RecordedTrial>& trials, Mains mains);

}  // namespace fingerpad
