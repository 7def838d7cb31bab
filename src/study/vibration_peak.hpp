#pragma once

#include <string>
#include <vector>

#include "study/trial_evidence.hpp"

namespace fingerpad {

/// The vibration of slip: the spectral peak of the force ratio along the motion.
struct VibrationPeak {
  double frequency_hz = 0, bandwidth_hz = 0;  ///< of the spectrum's peak, as SlipVibration's
  double power = 0, floor = 0;  ///< of the vibration [1], and the white density beneath it [1/Hz]
  double tilt = 0;              ///< exponent by which the density rises above the peak, beyond the model's:
                                ///< density ~ exp(tilt (f/frequency - 1))
  double rate_hz = 0;
  long windows = 0, trials = 0;
  std::vector<double>
      overlap;          ///< of the window with itself at each lag, so that a draw need not tell it anew
  std::string refusal;  ///< empty: it holds
};

/// The mean of all windows' densities; nothing in it where there is a refusal.
struct SlipDensity {
  std::vector<double> power;
  double rate_hz = 0;
  /// Lines near the mains' frequencies that were left in the forces and are a quarter or more of what stands
  /// there: 50 or 60.
  std::vector<double> lines_hz;
  long windows = 0, trials = 0;
  std::string refusal;
};
SlipDensity slip_density(const std::vector<TrialEvidence>& trials, const std::vector<int>& times);

/// Fits the pad's vibration, a damped oscillation that noise drives (SlipVibration with ticks that go on
/// between the samples; its peak is the spectrum's), and a white floor to Welch's densities of slip (Welch
/// 1967), by Whittle's likelihood (1953). The model is seen through the same window as the data, so that
/// neither its width nor the shortness of slips widens the peak. The density's tilt about the peak is fitted
/// too, as a sensor's low pass makes it fall more steeply, and a vibration that goes from sample to sample,
/// as in the program's own traces, less. Few windows tell no tilt, and the peak may be off by what the model
/// is: made at the samples' own ticks, it was .3 % low at 1 kHz and 1.2 % at 500 Hz.
///
/// Refused where no slip is long enough for a window, rates or lengths differ, or no density between 20 Hz
/// and nine tenths of half the rate stands out of the rest: three times the median, and where windows are few
/// as much more as noise alone hardly ever reaches. Nor is one that is highest at 20 Hz.
///
/// Where a line was left in, what stands within two steps of it is not looked at, and a vibration that the
/// rest shows there is refused: it may be the line.
/// @param near  where to begin, from an earlier fit that has shown it to stand out; nullptr: at the highest
///              density
VibrationPeak vibration_peak(const SlipDensity& density, const VibrationPeak* near = nullptr);

}  // namespace fingerpad
