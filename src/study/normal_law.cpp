#include "study/normal_law.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "study/delayed_evidence.hpp"
#include "study/fit_intervals.hpp"
#include "study/fit_refusals.hpp"
#include "study/impossible_numbers.hpp"
#include "study/next_point.hpp"
#include "study/sampling_reach.hpp"
#include "study/slope_window.hpp"
#include "study/zero_doubt.hpp"

namespace fingerpad {
namespace {

using PressedTrials = std::vector<const MeasuredTrial*>;

PressedTrials all_presses(const Measurement& measurement) {
  PressedTrials presses;
  presses.reserve(measurement.trials.size() + measurement.pressed.size());
  for (const auto* trials : {&measurement.trials, &measurement.pressed})
    for (const MeasuredTrial& trial : *trials) presses.push_back(&trial);
  return presses;
}

std::vector<TrialEvidence> evidence_of(const PressedTrials& presses, double exponent) {
  std::vector<TrialEvidence> evidence;
  evidence.reserve(presses.size());
  for (const MeasuredTrial* trial : presses) evidence.push_back(press_evidence(*trial, exponent));
  return evidence;
}

/// The same where force lags height by as much more as it may, so many times.
std::vector<TrialEvidence> delayed_evidence_of(const PressedTrials& presses, double exponent, double times) {
  std::vector<TrialEvidence> evidence;
  evidence.reserve(presses.size());
  for (const MeasuredTrial* trial : presses) {
    MeasuredTrial delayed = *trial;
    delay_heights(delayed, static_cast<std::size_t>(slope_half_window(trial->rate_hz)),
                  times * trial->delay_unsure_s);
    evidence.push_back(press_evidence(delayed, exponent));
  }
  return evidence;
}

/// The geometric mean of the trials' own mean forces.
double usual_load_n(const PressedTrials& presses) {
  double logs = 0;
  for (const MeasuredTrial* trial : presses) {
    double log_load = 0;
    for (const double n : trial->normal_force_n) log_load += std::log(n);
    logs += log_load / static_cast<double>(trial->normal_force_n.size());
  }
  return std::exp(logs / static_cast<double>(presses.size()));
}

std::size_t untared_of(const PressedTrials& presses, const Measurement& measurement) {
  std::set<std::string> tared;
  for (const TrialCleaning& cleaning : measurement.cleanings)
    if (cleaning.free_samples > 0) tared.insert(cleaning.name);
  return static_cast<std::size_t>(
      std::count_if(presses.begin(), presses.end(),
                    [&](const MeasuredTrial* trial) { return !tared.contains(trial->name); }));
}

/// A fit to the presses alone.
ProfileFit fit_to(const PressedTrials& presses, const Measurement& measurement, const FitSettings& settings) {
  ProfileFit fit;
  std::vector<int> subject_of;
  subject_of.reserve(presses.size());
  for (const MeasuredTrial* trial : presses) subject_of.push_back(trial->subject);
  fit.subjects = std::set<int>(subject_of.begin(), subject_of.end()).size();
  fit.trials = presses.size();
  FitPoint point;
  double& exponent = point.evidence.press_exponent;
  constexpr int most_passes = 10;
  constexpr double settled_exponent = 1e-3;
  double moved = 2 * settled_exponent;
  fit.evidence = evidence_of(presses, exponent);
  for (int pass = 1; pass < most_passes && moved > settled_exponent; ++pass) {
    const double next = next_point(fit.evidence, point).evidence.press_exponent;
    moved = std::abs(next - exponent);
    exponent = next;
    fit.evidence = evidence_of(presses, exponent);
  }
  fit.values = pad_numbers(fit.evidence, std::vector<int>(presses.size(), 1), point);
  tell_impossible_numbers(fit.values);
  if (value_of(fit.values, PadNumber::normal_stiffness).refusal.empty()) {
    std::vector<std::string> names;
    names.reserve(presses.size());
    for (const MeasuredTrial* trial : presses) names.push_back(trial->name);
    fit.outliers = outlier_trials(names, fit.evidence, exponent);
  }
  fit.mu_load_n = usual_load_n(presses);
  fit.offset.untared = untared_of(presses, measurement);
  const bool is_delay_told = std::all_of(presses.begin(), presses.end(),
                                         [](const MeasuredTrial* trial) { return trial->is_delay_told; });
  DelayReach by_delay;
  for (const double times : {1.0, -1.0}) {
    if (times < 0 && is_delay_told) continue;  // of a little either way tells the other
    by_delay.add(delayed_evidence_of(presses, exponent, times), fit, point);
  }
  add_intervals(subject_of, by_delay.moved, settings, point, fit);
  if (settings.keeps_told_by_few) return fit;
  if (!is_delay_told) {
    refuse_by_delay(by_delay.moved, fit);
    refuse_law_lost_by_delay(by_delay, fit);
  }
  doubt_zero(zero_doubt(fit, !measurement.looks_for_tare), fit);
  return fit;
}

}  // namespace

void take_normal_law(const Measurement& measurement, const FitSettings& settings, ProfileFit& fit) {
  const ProfileFit pressed = fit_to(all_presses(measurement), measurement, settings);
  for (const PadNumber number : {PadNumber::normal_stiffness, PadNumber::normal_exponent}) {
    const auto k = static_cast<std::size_t>(number);
    fit.values[k] = pressed.values[k];
    fit.interval[k] = pressed.interval[k];
    fit.no_interval[k] = pressed.no_interval[k];
  }
  std::erase_if(fit.outliers,
                [](const OutlierTrial& one) { return one.number == PadNumber::normal_stiffness; });
  fit.outliers.insert(fit.outliers.end(), pressed.outliers.begin(), pressed.outliers.end());
  fit.subjects = pressed.subjects;
  fit.trials = pressed.trials;
  fit.doubts.insert(fit.doubts.end(), pressed.doubts.begin(), pressed.doubts.end());
}

}  // namespace fingerpad
