#include "study/pad_numbers.hpp"

#include <fmt/format.h>

#include <optional>
#include <utility>
#include <vector>

#include "base/unit_ending.hpp"
#include "study/axis_numbers.hpp"
#include "study/hidden_stick.hpp"
#include "study/impossible_numbers.hpp"
#include "study/mu_load_exponent.hpp"
#include "study/press_fit.hpp"
#include "study/static_friction.hpp"
#include "study/subjects_mean.hpp"
#include "study/vibration_peak.hpp"

namespace fingerpad {
namespace {

/// Why too few ruptures tell where stick ends.
std::string no_rupture_words(const std::vector<TrialEvidence>& trials) {
  long short_teeth = 0;
  for (const TrialEvidence& trial : trials) short_teeth += trial.short_teeth;
  if (short_teeth == 0) return "no rupture from stick was found";
  return fmt::format(
      "{} rupture{} from stick {} of teeth with too few samples to tell where they gave way: rub slower, or "
      "sample faster",
      short_teeth, short_teeth == 1 ? "" : "s", short_teeth == 1 ? "is" : "are");
}

PadValue v_min_of_step(const std::vector<TrialEvidence>& trials, const std::vector<int>& times) {
  const std::optional<SpeedStep> step = speed_step(trials, times);
  if (!step) return {0, 0, 0, "no slip is slower than where friction steps"};
  return {step->speed_m_per_s, step->samples, step->trials, ""};
}

}  // namespace

PadValue seen_v_min(const std::vector<TrialEvidence>& trials, const std::vector<int>& times) {
  constexpr long enough_stops = 10;
  // Where teeth pass for slip it seems to end late. Those trials tell it only where no others do.
  std::vector<int> sure = times;
  for (std::size_t i = 0; i < trials.size(); ++i)
    if (trials[i].hides_teeth) sure[i] = 0;
  const auto mean_of = [&](const std::vector<int>& counted) {
    return subjects_mean(trials, counted, &TrialEvidence::stop_speed_m_per_s, &TrialEvidence::stops,
                         enough_stops, "no slip that ends in stick was found");
  };
  PadValue found = mean_of(sure);
  if (found.samples < enough_stops) found = mean_of(times);
  // What is seen once in a while may be a vibration's swing.
  constexpr long most_gives_a_stop = 10;
  long gives = 0;
  for (std::size_t i = 0; i < trials.size(); ++i) gives += times[i] * trials[i].gives;
  if (found.refusal.empty() && most_gives_a_stop * found.samples < gives)
    found.refuse(RefusalReason::other,
                 fmt::format("slip is seen to end in stick {} times only, where stick ends in "
                             "slip {} times: let the finger slow down to its stops",
                             found.samples, gives));
  return found;
}

PadValues pad_numbers(const std::vector<TrialEvidence>& trials, const std::vector<int>& times,
                      const FitPoint& point) {
  PadValues found;
  const auto at = [&](PadNumber number) -> PadValue& { return value_of(found, number); };
  at(PadNumber::mu_static) = static_friction(trials, times, point.pairs_friction);
  if (at(PadNumber::mu_static).samples == 0) at(PadNumber::mu_static).refusal = no_rupture_words(trials);
  at(PadNumber::mu_dynamic) = slip_mean(trials, times);
  if (point.contradicts_law)
    for (const PadNumber number : {PadNumber::mu_static, PadNumber::mu_dynamic})
      at(number).refuse(RefusalReason::contradiction, "mu_static comes out below mu_dynamic");
  at(PadNumber::mu_load_exponent) =
      mu_load_exponent(trials, times, point.evidence.load.exponent, point.trial_scatter);
  if (point.has_unseen_slip)
    at(PadNumber::mu_load_exponent)
        .refuse(RefusalReason::unseen_slip,
                "no slip is surely seen: what passes for it may be teeth of stick and slip, whose mean "
                "changes with the load in its own way; mu_static is taken as it is: rub faster");
  PadValue& v_min = at(PadNumber::v_min);
  if (point.v_min_by_step) {
    v_min = v_min_of_step(trials, times);
  } else {
    v_min = seen_v_min(trials, times);
    if (std::string words = hidden_stick_words(trials, times, point.slow_slip, found); !words.empty())
      v_min = {v_min.value, v_min.samples, v_min.trials, std::move(words), RefusalReason::hidden_stick};
  }
  add_axes(trials, times, point.evidence.bend, found);
  const VibrationPeak peak =
      vibration_peak(slip_density(trials, times), point.vibration ? &*point.vibration : nullptr);
  at(PadNumber::vibration) = {peak.frequency_hz, peak.windows, peak.trials, peak.refusal};
  at(PadNumber::vibration_bandwidth) = {peak.bandwidth_hz, peak.windows, peak.trials, peak.refusal};
  const PressFit press = fit_press(trials, times, point.evidence.press_exponent);
  at(PadNumber::normal_stiffness) = {1 / (press.depth_at_1_n_m * press.exponent), press.samples, press.trials,
                                     press.refusal};
  at(PadNumber::normal_exponent) = {1 / press.exponent, press.samples, press.trials, press.refusal};
  refuse_impossible_numbers(found);
  return found;
}

std::string_view unit_of_key(std::string_view key) noexcept {
  const std::string_view unit = unit_in_ending(key);
  return unit.empty() ? "1" : unit;
}

}  // namespace fingerpad
