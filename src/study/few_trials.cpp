#include "study/few_trials.hpp"

#include <fmt/format.h>

#include "base/number_text.hpp"

namespace fingerpad {
namespace {

constexpr long fewest_trials = 3;  // of which intervals are told

/// Why what was found of a vibration is none; empty where it may be one.
std::string no_vibration_words(const ProfileFit& fit) {
  const PadValue& bandwidth = value_of(fit.values, PadNumber::vibration_bandwidth);
  const auto& interval = fit.interval[static_cast<std::size_t>(PadNumber::vibration_bandwidth)];
  double rate_hz = 0;
  for (const TrialEvidence& trial : fit.evidence)
    if (trial.pieces > 0) rate_hz = trial.rate_hz;
  const double step_hz = rate_hz / static_cast<double>(vibration_window(rate_hz));
  if (bandwidth.value < step_hz)
    return fmt::format(
        "the peak of the spectrum of slip is {} Hz wide, less than the {} Hz that its windows part: no "
        "vibration of a pad is so even",
        rounded_text(bandwidth.value, 2), rounded_text(step_hz, 2));
  if (interval && !(interval->first > 0))
    return fmt::format(
        "the peak of the spectrum of slip is {} Hz wide, give or take {}: nothing is seen to vibrate for "
        "sure",
        rounded_text(bandwidth.value, 2), rounded_text(interval->second - bandwidth.value, 2));
  if (!interval && bandwidth.trials - static_cast<long>(fit.subjects) >= fewest_trials - 1)
    return "with other trials drawn of these no frequency stands out of the spectrum of slip: nothing is "
           "seen "
           "to vibrate for sure";
  return {};
}

void refuse(PadNumber number, const std::string& words, ProfileFit& fit) {
  value_of(fit.values, number).refusal = words;
  fit.interval[static_cast<std::size_t>(number)].reset();
}

}  // namespace

void refuse_untold(ProfileFit& fit) {
  const PadValue& v_min = value_of(fit.values, PadNumber::v_min);
  if (v_min.refusal.empty() && v_min.trials < fewest_trials)
    refuse(PadNumber::v_min,
           fmt::format("slip is seen to end in {} trial{} only, too few to tell how far it may be off: add "
                       "trials until it does in {}",
                       v_min.trials, v_min.trials == 1 ? "" : "s", fewest_trials),
           fit);
  if (!value_of(fit.values, PadNumber::vibration_bandwidth).refusal.empty()) return;
  const std::string words = no_vibration_words(fit);
  if (words.empty()) return;
  for (const PadNumber number : {PadNumber::vibration, PadNumber::vibration_bandwidth})
    refuse(number, words, fit);
}

std::string without_interval_words(const ProfileFit& fit) {
  std::string names;
  for (std::size_t k = 0; k < fit.values.size(); ++k) {
    if (!fit.values[k].refusal.empty() || fit.interval[k]) continue;
    names += fmt::format("{}{}", names.empty() ? "" : ", ", pad_number_keys[k]);
  }
  if (names.empty()) return {};
  return fmt::format("too few trials for an interval, so that these may be off by any amount: {}", names);
}

}  // namespace fingerpad
