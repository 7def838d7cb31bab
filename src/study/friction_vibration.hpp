#pragma once

#include <vector>

#include "friction/law_settings.hpp"
#include "study/report.hpp"

namespace fingerpad {

/// A finger pad with slip vibration (89 Hz, 20 Hz broad, 0.05 of mu_d n) on a plane at 1 N, mu 0.3 and 0.2.
struct VibratingDrag {
  double speed_m_per_s = 0.2;  ///< of the drag; the greatest, where it strokes
  double rate_hz = 1000;
  Restick restick = Restick::level;
  bool strokes = false;  ///< a sine of 10 mm to and fro; else a drag at constant speed
  bool vibrates = true;
};

/// What is felt of it, once slip has begun.
struct VibrationFelt {
  double slip_share = 0;        ///< of the time
  double band_share = 0;        ///< RMS of friction within 30 Hz of 89 Hz, over mu_d n
  std::vector<double> force_n;  ///< of each tick counted: friction against the first direction
};
VibrationFelt vibration_felt(const VibratingDrag& drag);

/// The same of a vibration that never pauses: what lies within those 30 Hz of all that is asked for.
double asked_band_share();

/// How much of the slip vibration is left below v_min, with both readings of restick, by speed.
void study_vibration(StudyReport& report);

}  // namespace fingerpad
