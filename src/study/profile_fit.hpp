#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "study/measurement.hpp"
#include "study/pad_numbers.hpp"

namespace fingerpad {

/// A profile from measurements.
struct ProfileFit {
  PadValues values;
  /// 95 %: low and high; nothing where the number is refused, or rests on too few trials.
  std::array<std::optional<std::pair<double, double>>, pad_number_keys.size()> interval;
  std::size_t subjects = 0, trials = 0;
};

/// Fits a pad's profile (pad_numbers).
///
/// Interval: a block bootstrap, the trials of each subject drawn with replacement (so it holds for these
/// subjects, not for those who were not measured); the estimate -+ Student's t times the spread of the draws,
/// widened by sqrt(n/(n-1)) for the n trials of a subject that a draw holds less different than they are.
/// The same seed gives the same intervals.
ProfileFit fit_profile(const Measurement& measurement, std::uint64_t seed);

/// The profile as a file (TOML), which read_profile takes if it has both axes.
std::string profile_text(const ProfileFit& fit, const std::string& source);

}  // namespace fingerpad
