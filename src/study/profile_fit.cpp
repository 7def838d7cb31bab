#include "study/profile_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "study/delayed_evidence.hpp"
#include "study/evidence_reach.hpp"
#include "study/few_trials.hpp"
#include "study/fit_intervals.hpp"
#include "study/fit_refusals.hpp"
#include "study/hidden_stick.hpp"
#include "study/impossible_numbers.hpp"
#include "study/next_point.hpp"
#include "study/normal_law.hpp"
#include "study/sampling_reach.hpp"
#include "study/silent_subjects.hpp"
#include "study/slow_sensor.hpp"
#include "study/spring_steps.hpp"
#include "study/static_friction.hpp"
#include "study/stretch_reach.hpp"
#include "study/unseen_slip.hpp"
#include "study/zero_doubt.hpp"

namespace fingerpad {
namespace {

/// Refuses all that there is no trial for.
void refuse_untold(const Measurement& measurement, ProfileFit& fit) {
  const std::string words = !measurement.pressed.empty()        ? measurement.pressed.front().lacks
                            : measurement.without_force.empty() ? "no trial has contact"
                                                                : measurement.without_force.front();
  for (PadValue& value : fit.values) {
    value.refusal = words;
    if (!measurement.pressed.empty()) value.reason = RefusalReason::no_friction;
  }
  if (measurement.pressed.empty()) return;
  fit.mu_load_n = 0;
  fit.residual = LawResidual();
}

/// What of a delay the springs tell beside what was taken out; 0 where there are none.
double delay_left_s(const std::vector<TrialEvidence>& trials, const std::vector<int>& times) {
  double sum_s = 0, samples = 0;
  for (const int axis : {0, 1}) {
    const SpringFit spring = fit_spring(trials, times, axis);
    sum_s += static_cast<double>(spring.samples) * spring.shape.delay_s;
    samples += static_cast<double>(spring.samples);
  }
  return samples > 0 ? sum_s / samples : 0;
}

/// Whether that is worth a word, and more than chance by the fits to all trials but some.
bool tells_delay_left(double left_s, const std::vector<TrialEvidence>& trials,
                      const std::vector<int>& subject_of) {
  constexpr double deviations = 2, least_told_s = 0.5e-3;
  if (!(std::abs(left_s) > least_told_s)) return false;
  if (static_cast<long>(trials.size()) < fewest_trials) return false;
  LeftOutSpread without;
  const std::size_t left_out = each_left_out(subject_of, Blocks::trials, [&](const LeftOut& one) {
    without.add(one, delay_left_s(trials, one.times));
  });
  const double deviation_s = without.deviation(left_out).value_or(0);
  return deviation_s > 0 && std::abs(left_s) > deviations * deviation_s;
}

/// The fit to the trials whose forces were measured whole.
ProfileFit whole_fit(const Measurement& measurement, const FitSettings& settings) {
  ProfileFit fit;
  std::vector<int> subject_of;
  std::vector<StickSegments> segments;
  for (const MeasuredTrial& trial : measurement.trials) {
    subject_of.push_back(trial.subject);
    segments.push_back(stick_segments(trial));
  }
  FitPoint point;
  point.evidence.knows_delay = measurement.knows_delay;
  point.takes_axes_exponent = settings.takes_axes_exponent;
  const FitPoint start = point;
  const auto gather = [&] {
    fit.evidence.clear();
    for (std::size_t i = 0; i < segments.size(); ++i) {
      segments[i].drop_tail = point.evidence.drop_tail;
      fit.evidence.push_back(trial_evidence(measurement.trials[i], segments[i], point.evidence));
    }
  };
  // The normal law's exponent comes last, where it is far from the half that it is looked for from.
  constexpr int passes = 4, most_passes = 10;
  constexpr double settled_exponent = 1e-3;
  bool took_exponent = false;
  const auto settle = [&] {
    double moved = 0;
    for (int pass = 0; pass < passes || (pass < most_passes && moved > settled_exponent); ++pass) {
      if (pass > 0) {
        const double before = point.evidence.press_exponent;
        point = next_point(fit.evidence, point);
        took_exponent |= point.evidence.axes_exponent != 0;
        moved = std::abs(point.evidence.press_exponent - before);
      }
      gather();
    }
  };
  const auto tell_stick = [&] {
    for (std::size_t i = 0; i < segments.size(); ++i)
      segments[i] = stick_segments(measurement.trials[i], point.evidence.axes_exponent);
    settle();
  };
  settle();
  if (point.evidence.axes_exponent != 0) {
    tell_stick();  // better, now that it is known how springs go with the load
    fit.axes_exponent = axes_exponent(fit.evidence, point.evidence.axes_exponent);
    if (point.evidence.axes_exponent == 0) fit.axes_exponent.reset();
  }
  if (took_exponent && !fit.axes_exponent) {
    // By the springs that it has told it is not sure any more: none is taken.
    point = start;
    point.takes_axes_exponent = false;
    tell_stick();
  }
  const std::vector<int> once(fit.evidence.size(), 1);
  fit.values = pad_numbers(fit.evidence, once, point);
  // The last pass' numbers may be the first that tell it, or that tell otherwise.
  if (point.has_unseen_slip == unseen_slip_words(fit.evidence, fit.values, point).empty()) {
    if (point.has_unseen_slip) {
      trust_slip(point);
    } else {
      doubt_slip(fit.evidence, point);
    }
    gather();
    fit.values = pad_numbers(fit.evidence, once, point);
  }
  if (contradicts_law(fit.values)) {
    point.contradicts_law = true;
    fit.values = pad_numbers(fit.evidence, once, point);
  }
  tell_impossible_numbers(fit.values);
  fit.mu_load_n = point.evidence.load.load_n;
  std::vector<std::string> names;
  for (const MeasuredTrial& trial : measurement.trials) names.push_back(trial.name);
  const bool tells_press = value_of(fit.values, PadNumber::normal_stiffness).refusal.empty();
  fit.outliers = outlier_trials(names, fit.evidence,
                                tells_press ? std::optional(point.evidence.press_exponent) : std::nullopt);
  fit.offset = sensor_offset(measurement, segments);
  const SpringFit lateral = fit_spring(fit.evidence, once, 0),
                  longitudinal = fit_spring(fit.evidence, once, 1);
  fit.looks_for_tare = measurement.looks_for_tare;
  fit.knows_delay = measurement.knows_delay;
  fit.took_delay =
      !fit.knows_delay && std::any_of(measurement.delays.begin(), measurement.delays.end(),
                                      [](const FileDelay& d) { return d.estimate.refusal.empty(); });
  fit.v_min_by_step = point.v_min_by_step;
  if (!fit.knows_delay) {
    fit.delay_left_s = delay_left_s(fit.evidence, once);
    fit.tells_delay_left = tells_delay_left(fit.delay_left_s, fit.evidence, subject_of);
  }
  fit.subjects = std::set<int>(subject_of.begin(), subject_of.end()).size();
  fit.trials = fit.evidence.size();
  fit.steps = measurement.steps;
  tell_light_samples(measurement, segments, fit);
  tell_slow_sensor(segments, point, fit);
  tell_silent_subjects(measurement, fit);
  tell_unlike_friction(names, point, fit);
  tell_axes_exponent(settings.takes_axes_exponent, fit);
  const std::string hidden =
      point.v_min_by_step ? "" : hidden_stick_words(fit.evidence, once, point.slow_slip, fit.values);
  std::string no_slip = unseen_slip_words(fit.evidence, fit.values, point);
  if (no_slip.empty() && point.has_unseen_slip) no_slip = hardly_seen_slip;
  const LawSpring spring{point.evidence, {lateral.shape, longitudinal.shape}, point.v_min_by_step};
  std::vector<TrialResidual> residuals;
  for (std::size_t i = 0; i < segments.size(); ++i)
    residuals.push_back(trial_residual(measurement.trials[i], segments[i], fit.evidence[i], spring));
  fit.residual = law_verdict(residuals, names,
                             {point.v_min_by_step || !hidden.empty(), point.v_min_by_step,
                              unseen_drop_share(fit.evidence), no_slip});
  const bool is_delay_told = std::all_of(measurement.trials.begin(), measurement.trials.end(),
                                         [](const MeasuredTrial& trial) { return trial.is_delay_told; });
  if (!is_delay_told) doubt_misfit(fit.residual);
  tell_noise(segments, fit);
  if (fit.evidence.empty()) {
    refuse_untold(measurement, fit);
    return fit;
  }
  if (!hidden.empty())
    refuse_springs(no_slip.empty() ? RefusalReason::hidden_stick : RefusalReason::unseen_slip, hidden,
                   fit.values);
  DelayReach by_delay;
  for (const double times : {1.0, -1.0}) {
    if (times < 0 && is_delay_told) continue;  // of a little either way tells the other
    by_delay.add(delayed_evidence(measurement, segments, point.evidence, fit.delay_left_s, times), fit,
                 point);
  }
  NumberReaches unsure = by_delay.moved;
  if (point.evidence.drop_tail > 0) {
    const NumberReaches by_tail = moved_by_tail(measurement, segments, fit, point);
    for (std::size_t k = 0; k < unsure.size(); ++k) unsure[k] += by_tail[k];
  }
  if (fit.axes_exponent) {
    const NumberReaches by_axes = moved_by_axes(measurement, segments, fit, point);
    for (std::size_t k = 0; k < unsure.size(); ++k) unsure[k] += by_axes[k];
  }
  if (point.has_unseen_slip) {
    const NumberReaches by_load = moved_by_load(measurement, segments, fit, point);
    for (std::size_t k = 0; k < unsure.size(); ++k) unsure[k] += by_load[k];
    fit.doubts.emplace_back(
        "how friction changes with the load is not told, as no slip is surely seen: intervals are wider by "
        "what a rise with the load's power of -1/3 would move, as a pad has it that flattens like a ball");
  }
  add_intervals(subject_of, unsure, settings, point, fit);
  if (!is_delay_told && !settings.keeps_told_by_few) {
    refuse_by_delay(by_delay.moved, fit);
    refuse_law_lost_by_delay(by_delay, fit);
  }
  tell_teeth(teeth_reach(fit, point), fit);
  refuse_vague_springs(settings.keeps_told_by_few, fit);
  refuse_odd_cubic_shares(fit);
  if (!settings.keeps_told_by_few) {
    if (is_bare_spring(fit))
      refuse_unsteady_springs(reach_by_stretches(measurement, segments, fit, point), fit);
    refuse_told_by_few(fit);
    if (!no_slip.empty() || point.has_unseen_slip) refuse_unsure_slip(fit);
    doubt_zero(zero_doubt(fit, !measurement.looks_for_tare), fit);
    doubt_straight_springs(fit);
  }
  return fit;
}

}  // namespace

ProfileFit fit_profile(const Measurement& measurement, const FitSettings& settings) {
  ProfileFit fit = whole_fit(measurement, settings);
  if (!measurement.pressed.empty()) take_normal_law(measurement, settings, fit);
  return fit;
}

}  // namespace fingerpad
