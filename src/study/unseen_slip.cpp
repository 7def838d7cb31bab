#include "study/unseen_slip.hpp"

#include <fmt/format.h>

#include "base/number_text.hpp"

namespace fingerpad {
namespace {

/// What gives way, and how fast what passes for slip is.
struct SlipSeen {
  long gives = 0, strokes = 0, drops = 0, stops = 0, teeth = 0, samples = 0;
  SlipBySpeed by_speed;
  double rate_hz = 0;              ///< the least
  double pulled = 0, moved_m = 0;  ///< springs: their mean stiffness is the quotient

  explicit SlipSeen(const std::vector<TrialEvidence>& trials) {
    for (const TrialEvidence& trial : trials) {
      gives += trial.gives;
      strokes += trial.strokes;
      drops += trial.stroke_drops;
      stops += trial.stops;
      teeth += trial.ruptures + trial.short_teeth;
      samples += trial.slip_samples;
      if (rate_hz == 0 || trial.rate_hz < rate_hz) rate_hz = trial.rate_hz;
      for (std::size_t bin = 0; bin < SlipBySpeed::bins; ++bin)
        by_speed.samples[bin] += trial.slip_by_speed.samples[bin];
      for (const SpringSums& spring : trial.spring) {
        pulled += spring(spring_straight, spring_straight);
        moved_m += spring(spring_position, spring_straight);
      }
    }
  }
  /// The speed below which a share of slip lies.
  double speed_m_per_s(double share) const {
    double all = 0, below = 0;
    for (const double samples_here : by_speed.samples) all += samples_here;
    std::size_t bin = 0;
    while (bin < SlipBySpeed::bins && !(below > share * all)) below += by_speed.samples[bin++];
    return SlipBySpeed::speed_m_per_s(bin);
  }
};

}  // namespace

bool slip_may_hold_teeth(const std::vector<TrialEvidence>& trials, const PadValues& found) {
  constexpr double fewest_samples = 5, slow_share = 0.25;
  const SlipSeen seen(trials);
  const PadValue &mu_static = value_of(found, PadNumber::mu_static),
                 &mu_dynamic = value_of(found, PadNumber::mu_dynamic);
  if (!mu_static.refusal.empty() || !mu_dynamic.refusal.empty() || !(seen.pulled > 0)) return true;
  const double tooth_m = 2 * (mu_static.value - mu_dynamic.value) * seen.moved_m / seen.pulled;
  return tooth_m * seen.rate_hz < fewest_samples * seen.speed_m_per_s(slow_share);
}

std::string unseen_slip_words(const std::vector<TrialEvidence>& trials, const PadValues& found,
                              const FitPoint& point) {
  constexpr long many_teeth = 4;  // for each time that stick began anew
  const SlipSeen seen(trials);
  if (seen.gives + seen.teeth == 0 || point.slow_slip) return {};
  // A few ends of stick tell no share of drops or of stops among them.
  if (seen.gives + seen.teeth < fewest_gives) {
    if (seen.samples == 0 || seen.stops > 0 || !slip_may_hold_teeth(trials, found)) return {};
  } else if (seen.samples == 0) {
    return fmt::format(
        "no slip is seen: stick gives way {} times, and each time holds again at once: rub faster",
        seen.teeth);
  }
  const bool ends_in_stick = seen.stops > 0 && !hardly_ends_in_stick(seen.gives, seen.stops);
  const bool has_teeth = seen.teeth - seen.drops > many_teeth * seen.strokes,
             shows_drops = seen.strokes > 0 && 2 * seen.drops >= seen.strokes;
  if (ends_in_stick || (shows_drops && !has_teeth && !slip_may_hold_teeth(trials, found))) return {};
  return fmt::format(
      "no slip is surely seen: what passes for it, at up to {} m/s, is hardly seen to end in stick, and may "
      "be stick "
      "that gives way again within a few samples: rub faster, or sample faster",
      rounded_text(seen.speed_m_per_s(0.95), 2));
}

}  // namespace fingerpad
