#include "study/slow_rubs.hpp"

#include <fmt/format.h>

#include "base/number_text.hpp"
#include "friction/pad_profile.hpp"

namespace fingerpad {
namespace {

/// The speed that hardly any slip exceeds; 0 where nothing passes for slip.
double fastest_slip_m_per_s(const std::vector<TrialEvidence>& trials) {
  constexpr double hardly_any = 0.05;
  double all = 0, above = 0;
  for (const TrialEvidence& trial : trials)
    for (const double samples : trial.slip_by_speed.samples) all += samples;
  if (!(all > 0)) return 0;
  std::size_t bin = SlipBySpeed::bins;
  while (bin > 0 && !(above > hardly_any * all)) {
    --bin;
    for (const TrialEvidence& trial : trials) above += trial.slip_by_speed.samples[bin];
  }
  return SlipBySpeed::speed_m_per_s(bin + 1);
}

}  // namespace

std::string slow_rubs_words(const std::vector<TrialEvidence>& trials) {
  constexpr long fewest_breaks = 5;
  constexpr double hardly_any_stops = 0.25;
  long gives = 0, stops = 0, teeth = 0, slip_samples = 0;
  for (const TrialEvidence& trial : trials) {
    gives += trial.gives;
    stops += trial.stops;
    teeth += trial.ruptures + trial.short_teeth;
    slip_samples += trial.slip_samples;
  }
  const bool ends_in_stick =
      stops > 0 && static_cast<double>(stops) >= hardly_any_stops * static_cast<double>(gives);
  if (gives + teeth < fewest_breaks || ends_in_stick) return {};
  if (slip_samples == 0)
    return fmt::format(
        "no rub is fast enough to see slip: stick gives way {} times, and each time holds again before the "
        "finger has slipped: rub faster",
        gives + teeth);
  const double fastest_m_per_s = fastest_slip_m_per_s(trials);
  if (!(fastest_m_per_s < PadProfile().v_min_m_per_s)) return {};
  return fmt::format(
      "no rub is fast enough to see slip: what passes for it, up to {} m/s, is hardly seen to end in stick, "
      "and may be stick that gives way again within a few samples: rub faster than {} m/s",
      rounded_text(fastest_m_per_s, 2), rounded_text(PadProfile().v_min_m_per_s, 2));
}

void refuse_slip(const std::string& words, ProfileFit& fit) {
  for (const PadNumber number : {PadNumber::mu_dynamic, PadNumber::mu_load_exponent, PadNumber::v_min,
                                 PadNumber::vibration, PadNumber::vibration_bandwidth}) {
    value_of(fit.values, number).refusal = words;
    fit.interval[static_cast<std::size_t>(number)].reset();
  }
}

}  // namespace fingerpad
