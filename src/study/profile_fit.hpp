#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "study/block_draws.hpp"
#include "study/measurement.hpp"
#include "study/pad_numbers.hpp"

namespace fingerpad {

/// A trial whose number is far from those of its subject's other trials. It is listed, and counted all the
/// same.
struct OutlierTrial {
  std::size_t trial = 0;  ///< of Measurement::trials
  std::string name;
  PadNumber number = PadNumber::mu_static;
  double value = 0, usual = 0;  ///< its own, and the median of the subject's
};

/// How well the pad's law repeats the measured forces.
struct LawResidual {
  double share = 0;     ///< RMS of what it leaves of the force ratio, over the RMS of that
  double expected = 0;  ///< likewise, of the sensors' noise and the vibration of slip
  long samples = 0;
  std::string misfit;  ///< why the pad's law does not fit; empty where it does
};

/// A profile from measurements.
struct ProfileFit {
  PadValues values;
  /// 95 %: low and high; nothing where the number is refused, or rests on too few trials.
  std::array<std::optional<std::pair<double, double>>, pad_number_keys.size()> interval;
  double mu_load_n = 0;  ///< normal force at which mu_static and mu_dynamic hold: the geometric mean in slip
  std::size_t subjects = 0, trials = 0;
  std::vector<TrialEvidence> evidence;  ///< per trial of the measurement
  std::vector<OutlierTrial> outliers;
  LawResidual residual;
  std::vector<std::string> steps;  ///< Measurement::steps
};

/// How intervals are made.
struct FitSettings {
  std::uint64_t seed = 1;
  Blocks blocks = Blocks::trials;
};

/// Fits a pad's profile (pad_numbers).
///
/// Interval: a block bootstrap, the trials of each subject drawn with replacement (so it holds for these
/// subjects, not for those who were not measured; with Blocks::subjects whole subjects are drawn); the
/// estimate -+ Student's t times the spread of the draws (interval_reach). The same seed gives the same
/// intervals.
ProfileFit fit_profile(const Measurement& measurement, const FitSettings& settings);

/// The profile as a file (TOML), which read_profile takes if it has both axes.
std::string profile_text(const ProfileFit& fit, const std::string& source);

}  // namespace fingerpad
