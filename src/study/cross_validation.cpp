#include "study/cross_validation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "study/pad_run.hpp"

namespace fingerpad {
namespace {

constexpr int most_folds = 4;

/// The fold of each trial. Subjects begin with different folds, so that one fold does not hold everyone's
/// first angle.
std::vector<int> folds_of(const Measurement& measurement, int& folds) {
  std::map<int, int> counted, order;
  std::vector<int> place;
  for (const MeasuredTrial& trial : measurement.trials) {
    order.emplace(trial.subject, static_cast<int>(order.size()));
    place.push_back(counted[trial.subject]++ + order[trial.subject]);
  }
  folds = 0;
  for (const auto& [subject, count] : counted) folds = std::max(folds, std::min(count, most_folds));
  if (folds < 2) folds = std::min(static_cast<int>(measurement.trials.size()), most_folds);
  std::vector<int> fold;
  fold.reserve(place.size());
  for (const int at : place) fold.push_back(folds > 0 ? at % folds : 0);
  return fold;
}

Measurement without_fold(const Measurement& measurement, const std::vector<int>& fold, int left_out) {
  Measurement rest = measurement;  // all that cleaning knows
  rest.trials.clear();
  rest.pressed.clear();  // they tell nothing of friction, which is what is foretold
  for (std::size_t i = 0; i < measurement.trials.size(); ++i)
    if (fold[i] != left_out) rest.trials.push_back(measurement.trials[i]);
  return rest;
}

double rms_left_n(const MeasuredTrial& trial, const std::vector<Vec2>& model_n) {
  double squares = 0;
  for (std::size_t i = 0; i < model_n.size(); ++i)
    squares += (model_n[i] - trial.normal_force_n[i] * trial.force_ratio[i]).squaredNorm();
  return std::sqrt(squares / static_cast<double>(std::max<std::size_t>(model_n.size(), 1)));
}

HeldOutTrial held_out(const MeasuredTrial& trial, const PadOnPlate& fitted) {
  const StickSegments segments = stick_segments(trial);
  HeldOutTrial held{trial.name, trial.subject, static_cast<long>(trial.position_m.size()), 0, 0, 0, 0};
  held.measured_rms_n = rms_left_n(trial, std::vector<Vec2>(trial.position_m.size(), Vec2(0, 0)));
  const PadOnPlate built_in = built_in_pad();
  held.built_in_rms_n = rms_left_n(trial, pad_force_n(trial, segments, built_in));
  const PadOnPlate own_friction{
      assumed_profile(fitted.mu_static, built_in.mu_static / built_in.profile.lateral_axis_m),
      fitted.mu_static, fitted.mu_dynamic};
  held.own_friction_rms_n = rms_left_n(trial, pad_force_n(trial, segments, own_friction));
  held.fitted_rms_n = rms_left_n(trial, pad_force_n(trial, segments, fitted));
  return held;
}

double over_subjects(const std::vector<HeldOutTrial>& trials, double HeldOutTrial::*number) {
  std::map<int, std::pair<double, double>> subjects;
  for (const HeldOutTrial& trial : trials) {
    auto& [squares, samples] = subjects[trial.subject];
    squares += static_cast<double>(trial.samples) * trial.*number * trial.*number;
    samples += static_cast<double>(trial.samples);
  }
  double sum = 0;
  for (const auto& [subject, sums] : subjects) sum += sums.first / sums.second;
  return std::sqrt(sum / static_cast<double>(std::max<std::size_t>(subjects.size(), 1)));
}

}  // namespace

CrossValidation cross_validate(const Measurement& measurement, const FitSettings& settings) {
  CrossValidation checked;
  int folds = 0;
  const std::vector<int> fold = folds_of(measurement, folds);
  if (folds < 2) {
    checked.refusal = measurement.trials.empty() && !measurement.pressed.empty()
                          ? "no trial has a force along the plate to foretell"
                          : "it takes two trials, one to fit and one to foretell";
    return checked;
  }
  std::vector<std::optional<HeldOutTrial>> told(measurement.trials.size());
  FitSettings of_fold = settings;
  of_fold.keeps_told_by_few = true;
  for (int left_out = 0; left_out < folds; ++left_out) {
    const ProfileFit fit = fit_profile(without_fold(measurement, fold, left_out), of_fold);
    if (!is_runnable(fit)) {
      checked.refusal =
          "without some of the trials the others do not give a pad with both coefficients of friction";
      checked.not_foretold += std::count(fold.begin(), fold.end(), left_out);
      continue;
    }
    const PadOnPlate fitted = fitted_pad(fit);
    for (std::size_t i = 0; i < measurement.trials.size(); ++i)
      if (fold[i] == left_out) told[i] = held_out(measurement.trials[i], fitted);
  }
  for (std::optional<HeldOutTrial>& trial : told)
    if (trial) checked.trials.push_back(std::move(*trial));
  if (checked.trials.empty()) return checked;
  checked.refusal.clear();
  checked.measured_rms_n = over_subjects(checked.trials, &HeldOutTrial::measured_rms_n);
  checked.built_in_rms_n = over_subjects(checked.trials, &HeldOutTrial::built_in_rms_n);
  checked.own_friction_rms_n = over_subjects(checked.trials, &HeldOutTrial::own_friction_rms_n);
  checked.fitted_rms_n = over_subjects(checked.trials, &HeldOutTrial::fitted_rms_n);
  return checked;
}

StudyTable cross_validation_table(const CrossValidation& checked) {
  StudyTable table{"cross_validation",
                   {"trial", "subject", "samples", "measured_rms_n", "built_in_rms_n", "own_friction_rms_n",
                    "fitted_rms_n"},
                   {}};
  for (const HeldOutTrial& trial : checked.trials) {
    table.rows.push_back({trial.name, static_cast<double>(trial.subject), static_cast<double>(trial.samples),
                          trial.measured_rms_n, trial.built_in_rms_n, trial.own_friction_rms_n,
                          trial.fitted_rms_n});
  }
  return table;
}

std::string cross_validation_words(const CrossValidation& checked) {
  if (!checked.refusal.empty()) return "no cross-validation: " + checked.refusal;
  return fmt::format(
      "on trials that a fit has not seen ({} of them), of {:.3g} N RMS of tangential force the fitted pad "
      "leaves "
      "{:.3g} N, the built-in pad {:.3g} N, and with the fitted coefficients of friction {:.3g} N{}",
      checked.trials.size(), checked.measured_rms_n, checked.fitted_rms_n, checked.built_in_rms_n,
      checked.own_friction_rms_n,
      checked.not_foretold > 0
          ? fmt::format("; {} of {} trials are left out, for without them the others give no pad with both "
                        "coefficients of friction",
                        checked.not_foretold, checked.not_foretold + static_cast<long>(checked.trials.size()))
          : "");
}

}  // namespace fingerpad
