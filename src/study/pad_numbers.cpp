#include "study/pad_numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "base/number_text.hpp"
#include "base/unit_ending.hpp"
#include "study/hidden_stick.hpp"
#include "study/impossible_numbers.hpp"
#include "study/load_exponent.hpp"
#include "study/press_fit.hpp"
#include "study/rupture_sums.hpp"
#include "study/spring_fit.hpp"
#include "study/unseen_slip.hpp"
#include "study/vibration_peak.hpp"

namespace fingerpad {
namespace {

constexpr double assumed_mu_static = 0.3;  // a profile's default
constexpr double enough_ruptures = 10;     // beyond which they hardly add to a trial's weight

using EvidenceSum = double TrialEvidence::*;
using EvidenceCount = long TrialEvidence::*;

/// The mean of the subjects' means. A trial's weight grows with its samples up to `enough` and hardly beyond:
/// more of them say the same trial again, and a trial of low mu_s ruptures more often.
PadValue subjects_mean(const std::vector<TrialEvidence>& trials, const std::vector<int>& times,
                       EvidenceSum sum, EvidenceCount count, double enough, const std::string& refusal) {
  std::map<int, std::pair<double, double>> subjects;
  PadValue found;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    const long here = times[i] * trials[i].*count;
    if (here == 0) continue;
    auto& [total, weight] = subjects[trials[i].subject];
    const auto count_here = static_cast<double>(trials[i].*count);
    const double own = times[i] * count_here / (count_here + enough);
    total += own * trials[i].*sum / count_here;
    weight += own;
    found.samples += here;
    found.trials += times[i];
  }
  for (const auto& [subject, mean] : subjects)
    found.value += mean.first / mean.second / static_cast<double>(subjects.size());
  if (subjects.empty()) found.refusal = refusal;
  return found;
}

/// The stiffness over all pushed directions, where axes are not known.
PadValue plain_stiffness(const std::vector<TrialEvidence>& trials, const std::vector<int>& times) {
  std::map<int, std::pair<double, double>> subjects;
  PadValue found;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    const SpringSums both = trials[i].spring[0] + trials[i].spring[1];
    if (times[i] == 0 || trials[i].stick_samples == 0 || !(both(spring_straight, spring_straight) > 0))
      continue;
    auto& [reach, spread] = subjects[trials[i].subject];
    reach += times[i] * both(spring_position, spring_straight);
    spread += times[i] * both(spring_straight, spring_straight);
    found.samples += times[i] * trials[i].stick_samples;
    found.trials += times[i];
  }
  for (const auto& [subject, sums] : subjects)
    found.value += sums.second / sums.first / static_cast<double>(subjects.size());
  if (!(found.value > 0)) found.refusal = "no stretch of stick was found";
  return found;
}

/// A number that rests on one axis' stick.
PadValue of_axis(const SpringFit& fit, double value, const std::string& refusal) {
  return {value, fit.samples, fit.trials, refusal,
          refusal.empty()   ? RefusalReason::other
          : fit.samples > 0 ? RefusalReason::one_angle
                            : RefusalReason::not_pushed};
}

/// Where a number of one axis stands.
struct AxisNumbers {
  PadNumber axis, slope, stiffness, linearity, cubic_share, hysteresis_area;
};
constexpr AxisNumbers axis_numbers[] = {
    {PadNumber::lateral_axis, PadNumber::lateral_slope, PadNumber::stick_stiffness,
     PadNumber::lateral_linearity, PadNumber::lateral_cubic_share, PadNumber::lateral_hysteresis_area},
    {PadNumber::longitudinal_axis, PadNumber::longitudinal_slope, PadNumber::longitudinal_stiffness,
     PadNumber::longitudinal_linearity, PadNumber::longitudinal_cubic_share,
     PadNumber::longitudinal_hysteresis_area},
};

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

/// The spring as it was fitted about a bend, at an end that may be another.
struct FittedSpring {
  double reach = 0;        ///< over A, at the end
  double cubic_share = 0;  ///< from what the reach is short of that of the first slope
};

FittedSpring fitted_spring(const SpringBend& bend, double share_left, double mu_static) {
  const Vec2 end = bend.at(mu_static), begin = bend.at(0);
  const double secant = end[0] + share_left * end[1], slope = begin[0] + share_left * begin[1];
  return {mu_static * secant, 1 - secant / slope};
}

void add_axis(const SpringFit& fit, const SpringBend& bend, const AxisNumbers& numbers, PadValues& found) {
  const PadValue& mu_static = value_of(found, PadNumber::mu_static);
  const bool has_limit = mu_static.refusal.empty();
  const double mu = has_limit ? mu_static.value : assumed_mu_static;
  const FittedSpring spring = fitted_spring(bend, fit.shape.share_left, mu);
  const double axis_m = has_limit ? fit.compliance45_m * spring.reach : fit.straight45_m * mu;
  const std::string no_limit = "where the spring ends is not known, as mu_static is not";
  const std::string shape_refusal = has_limit ? fit.shape_refusal : no_limit,
                    loop_refusal = has_limit ? fit.hysteresis_refusal : no_limit;
  value_of(found, numbers.axis) = of_axis(fit, axis_m, fit.axis_refusal);
  value_of(found, numbers.slope) = of_axis(fit, fit.slope_per_deg, fit.slope_refusal);
  value_of(found, numbers.stiffness) = of_axis(fit, mu / axis_m, fit.axis_refusal);
  value_of(found, numbers.linearity) = of_axis(fit, fit.linearity, fit.shape_refusal);
  value_of(found, numbers.cubic_share) = of_axis(fit, spring.cubic_share, shape_refusal);
  value_of(found, numbers.hysteresis_area) = of_axis(fit, 4 * fit.shape.hysteresis_m * mu, loop_refusal);
}

PadValue v_min_of_step(const std::vector<TrialEvidence>& trials, const std::vector<int>& times) {
  const std::optional<SpeedStep> step = speed_step(trials, times);
  if (!step) return {0, 0, 0, "no slip is slower than where friction steps"};
  return {step->speed_m_per_s, step->samples, step->trials, ""};
}

/// The spring that was found, for the next pass. The law's shares begin at 0.
void take_bends(const PadValues& found, EvidencePoint& next) {
  constexpr double most_bent = 0.9;
  const PadValue& mu_static = value_of(found, PadNumber::mu_static);
  if (!mu_static.refusal.empty()) return;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const PadValue& share = value_of(found, axis_numbers[axis].cubic_share);
    next.bend[axis].mu_static = mu_static.value;
    if (share.refusal.empty()) next.bend[axis].cubic_share = std::clamp(share.value, 0.0, most_bent);
  }
}

}  // namespace

PadValue seen_v_min(const std::vector<TrialEvidence>& trials, const std::vector<int>& times) {
  PadValue found = subjects_mean(trials, times, &TrialEvidence::stop_speed_m_per_s, &TrialEvidence::stops, 10,
                                 "no slip that ends in stick was found");
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
  at(PadNumber::mu_static) =
      subjects_mean(trials, times, &TrialEvidence::rupture_ratio, &TrialEvidence::ruptures, enough_ruptures,
                    no_rupture_words(trials));
  at(PadNumber::mu_dynamic) = subjects_mean(trials, times, &TrialEvidence::slip_ratio,
                                            &TrialEvidence::slip_samples, 500, "no slip was found");
  at(PadNumber::mu_load_exponent) =
      load_exponent(trials, times, point.evidence.load.exponent, point.trial_scatter);
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
  for (int axis = 0; axis < 2; ++axis)
    add_axis(fit_spring(trials, times, axis), point.evidence.bend[static_cast<std::size_t>(axis)],
             axis_numbers[axis], found);
  const bool has_direction =
      std::any_of(trials.begin(), trials.end(), [](const TrialEvidence& t) { return t.has_direction; });
  if (!has_direction) at(PadNumber::stick_stiffness) = plain_stiffness(trials, times);
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

void doubt_slip(const std::vector<TrialEvidence>& trials, FitPoint& point) {
  point.has_unseen_slip = true;
  point.load_of_slip = point.evidence.load;
  point.evidence.load.exponent = 0;
  const PadValue log_load =
      subjects_mean(trials, std::vector<int>(trials.size(), 1), &TrialEvidence::rupture_log_load,
                    &TrialEvidence::ruptures, enough_ruptures, "no rupture");
  if (log_load.refusal.empty())
    point.evidence.load.load_n = std::stod(rounded_text(std::exp(log_load.value), 3));
}

void trust_slip(FitPoint& point) {
  point.has_unseen_slip = false;
  point.evidence.load = point.load_of_slip;
}

FitPoint next_point(const std::vector<TrialEvidence>& trials, const FitPoint& point) {
  const std::vector<int> once(trials.size(), 1);
  FitPoint next = point;
  if (const auto log_load = mean_log_load(trials))
    next.evidence.load.load_n = std::stod(rounded_text(std::exp(*log_load), 3));
  next.trial_scatter = trial_scatter(trials);
  const PadValue exponent = load_exponent(trials, once, point.evidence.load.exponent, next.trial_scatter);
  if (exponent.refusal.empty()) next.evidence.load.exponent = exponent.value;
  const PressFit press = fit_press(trials, once, point.evidence.press_exponent);
  if (press.exponent > 0) next.evidence.press_exponent = std::clamp(press.exponent, 0.1, 2.0);
  const VibrationPeak peak = vibration_peak(slip_density(trials, once));
  next.vibration = peak.refusal.empty() ? std::optional(peak) : std::nullopt;
  const PadValues found = pad_numbers(trials, once, point);
  take_bends(found, next.evidence);
  const PadValue& mu_static = value_of(found, PadNumber::mu_static);
  next.evidence.mu_static = mu_static.refusal.empty() ? mu_static.value : 0;
  const PadValue& v_min = value_of(found, PadNumber::v_min);
  next.evidence.v_min_m_per_s = v_min.refusal.empty() ? v_min.value : 0;
  next.slow_slip = speed_step(trials, once);
  const bool step_left_no_slip =
      point.v_min_by_step && !value_of(found, PadNumber::mu_dynamic).refusal.empty();
  next.distrusts_step = point.distrusts_step || step_left_no_slip;
  if (next.slow_slip && (next.distrusts_step || !is_hidden_stick(found, *next.slow_slip)))
    next.slow_slip.reset();
  next.v_min_by_step = next.slow_slip && tells_v_min(*next.slow_slip, seen_v_min(trials, once));
  const PadValue& mu_dynamic = value_of(found, PadNumber::mu_dynamic);
  const bool may_hide = may_hide_stick(trials, next.slow_slip, found);
  next.evidence.hidden_stick_ratio = may_hide && mu_dynamic.refusal.empty() ? mu_dynamic.value : 0;
  if (next.slow_slip)
    next.evidence.v_min_m_per_s = std::max(next.evidence.v_min_m_per_s, next.slow_slip->speed_m_per_s);
  next.evidence.rupture_lag = rupture_lag(trials);
  next.has_unseen_slip = false;
  if (!unseen_slip_words(trials, found, next).empty()) doubt_slip(trials, next);
  return next;
}

std::string_view unit_of_key(std::string_view key) noexcept {
  const std::string_view unit = unit_in_ending(key);
  return unit.empty() ? "1" : unit;
}

}  // namespace fingerpad
