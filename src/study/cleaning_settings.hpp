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

/// The steps from raw samples to clean ones; see clean().
struct CleaningSettings {
  double longest_fill_s = 0.02;  ///< gaps up to this are filled with a straight line; 0: none is
  Mains mains = Mains::any;
  bool takes_tare = true;
  bool takes_delay = true;        ///< estimated by cross-correlation, and taken out
  std::optional<double> delay_s;  ///< known: taken out instead of the estimate
  double smoothing_hz = 0;        ///< zero-phase low pass of forces and positions; 0: off
};

}  // namespace fingerpad
