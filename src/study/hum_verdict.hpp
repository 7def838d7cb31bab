#pragma once

#include <string>
#include <vector>

#include "study/mains_hum.hpp"

namespace fingerpad {

/// Of the lines near 50 or 60 Hz of a measurement's trials, those that are mains hum.
struct HumVerdict {
  std::vector<std::vector<HumLine>> lines;             ///< of each trial, to be taken off
  std::vector<std::vector<LineLeftIn>> lines_left_in;  ///< of each trial, the others
  std::vector<std::string> left_in;                    ///< which those are, with their size and why
};

/// Tells mains hum from teeth of stick and slip, which make such lines too where a finger moves evenly.
///
/// Each line is asked in turn, until one answer is sure: is it there where no teeth can be, as nothing
/// touches the sensor or the finger stands still (in its own trial; else in those whose line has the same
/// frequency)? Does its amplitude and phase run on through windows of 0.2 s while the
/// finger turns round or changes its speed, as hum's does and teeth's do not? Does it stand at one frequency
/// in most trials that can show one, although their speeds differ? Else it is left in.
///
/// Where the finger's position has the line too, the force may really be there: only what the line is without
/// contact is asked.
///
/// Of a trial that is seen in the air, the line's amplitude and phase there bound what is hum, where the
/// whole of it differs: the rest is teeth's, and left in.
///
/// Mains::hz_50 or hz_60 is the user's word, and overrides all of this.
HumVerdict judge_hum(const std::vector<RecordedTrial>& trials, Sensed sensed, Mains mains);

}  // namespace fingerpad
