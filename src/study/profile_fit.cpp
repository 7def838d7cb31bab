#include "study/profile_fit.hpp"

#include <fmt/format.h>

#include <cmath>
#include <set>

#include "base/number_text.hpp"
#include "base/random_stream.hpp"
#include "scene/toml_tree.hpp"

namespace fingerpad {
namespace {

constexpr int bootstrap_draws = 400;

void add_intervals(const std::vector<int>& subject_of, const FitSettings& settings, ProfileFit& fit) {
  std::array<DrawSpread, pad_number_keys.size()> spreads;
  RandomStream random(settings.seed);
  for (int draw = 0; draw < bootstrap_draws; ++draw) {
    const PadValues values = pad_numbers(fit.evidence, drawn_times(subject_of, settings.blocks, random));
    for (std::size_t k = 0; k < values.size(); ++k)
      if (values[k].refusal.empty()) spreads[k].add(values[k].value);
  }
  const auto subjects = static_cast<double>(fit.subjects);
  for (std::size_t k = 0; k < spreads.size(); ++k) {
    constexpr double most_missing = 0.05;
    if (!fit.values[k].refusal.empty() || spreads[k].count < (1 - most_missing) * bootstrap_draws) continue;
    const double reach =
        settings.blocks == Blocks::subjects
            ? interval_reach(spreads[k], subjects, 1)
            : interval_reach(spreads[k], static_cast<double>(fit.values[k].trials), subjects);
    if (reach > 0) fit.interval[k] = {fit.values[k].value - reach, fit.values[k].value + reach};
  }
}

}  // namespace

ProfileFit fit_profile(const Measurement& measurement, const FitSettings& settings) {
  ProfileFit fit;
  std::vector<int> subject_of;
  for (const MeasuredTrial& trial : measurement.trials) {
    subject_of.push_back(trial.subject);
    fit.evidence.push_back(trial_evidence(trial, stick_segments(trial)));
  }
  fit.subjects = std::set<int>(subject_of.begin(), subject_of.end()).size();
  fit.trials = fit.evidence.size();
  fit.steps = measurement.steps;
  fit.values = pad_numbers(fit.evidence, std::vector<int>(fit.evidence.size(), 1));
  if (fit.evidence.empty()) {
    for (PadValue& value : fit.values)
      value.refusal =
          measurement.without_force.empty() ? "no trial has contact" : measurement.without_force.front();
    return fit;
  }
  add_intervals(subject_of, settings, fit);
  return fit;
}

std::string profile_text(const ProfileFit& fit, const std::string& source) {
  std::string numbers, intervals, samples, refusals;
  for (std::size_t k = 0; k < pad_number_keys.size(); ++k) {
    const PadValue& value = fit.values[k];
    const std::string_view key = pad_number_keys[k];
    if (!value.refusal.empty()) {
      refusals += fmt::format("{} = {}\n", key, write_toml_value(toml_text(value.refusal)));
      continue;
    }
    const auto decimal = [](double number) {
      const std::string text = number_text(number);
      return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
    };
    numbers += fmt::format("{} = {}\n", key, decimal(value.value));
    samples += fmt::format("{} = {}\n", key, value.samples);
    if (const auto& both = fit.interval[k])
      intervals += fmt::format("{} = [{}, {}]\n", key, decimal(both->first), decimal(both->second));
  }
  return fmt::format(
      "{}source = {}\n\n[interval]  # 95 %, over the trials of these subjects\n{}"
      "\n[samples]  # of stick or slip; of mu_static ruptures, of v_min ends of slip, of "
      "vibration_hz windows\n{}\n[refused]\n{}",
      numbers, write_toml_value(toml_text(source)), intervals, samples, refusals);
}

}  // namespace fingerpad
