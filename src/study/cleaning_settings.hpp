#pragma once

#include <array>
#include <optional>

namespace fingerpad {

/// Which mains hum is looked for in the forces.
enum class Mains { off, any, hz_50, hz_60 };

struct MainsFrequency {
  Mains mains;  ///< by which it alone is meant
  double hz;
};
inline constexpr std::array<MainsFrequency, 2> mains_frequencies{{{Mains::hz_50, 50}, {Mains::hz_60, 60}}};

/// Of what a trial is pressed with: samples of less have much noise in their force ratios, and may be of
/// another spring than the trial's.
inline constexpr double usual_light_share = 0.25;

/// The steps from raw samples to clean ones; see clean().
struct CleaningSettings {
  double longest_fill_s = 0.02;  ///< gaps up to this are filled with a straight line; 0: none is
  Mains mains = Mains::any;
  bool takes_tare = true;
  bool takes_axes_exponent = true;  ///< FitSettings', for the delay
  bool takes_delay = true;          ///< estimated by cross-correlation, and taken out
  std::optional<double> delay_s;    ///< known: taken out instead of the estimate
  double smoothing_hz = 0;          ///< zero-phase low pass of forces and positions; 0: off
  /// Samples that are pressed with less than this share of what their trial is pressed with tell neither
  /// stick nor slip; 0: all do that stand out of their noise.
  double light_share = usual_light_share;
};

}  // namespace fingerpad
