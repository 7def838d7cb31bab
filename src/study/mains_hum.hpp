#pragma once

#include "study/cleaning_settings.hpp"
#include "study/recorded_trial.hpp"

namespace fingerpad {

/// What was found of mains hum in a trial's forces.
struct MainsHum {
  double frequency_hz = 0;  ///< 0: none stands out
  double amplitude_n = 0;   ///< the greatest of the axes
};

/// Takes mains hum out of a trial's forces: on each axis the sine of constant amplitude and phase that stands
/// out of the spectrum (Hann window over the whole trial) twelvefold in power, near 50 or 60 Hz. What does
/// not keep its phase, as a vibration of the pad at that frequency, stays.
MainsHum remove_mains_hum(RecordedTrial& trial, Mains mains);

}  // namespace fingerpad
