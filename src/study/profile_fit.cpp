#include "study/profile_fit.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "base/number_text.hpp"
#include "base/random_stream.hpp"
#include "scene/toml_tree.hpp"

namespace fingerpad {
namespace {

constexpr int bootstrap_draws = 400;

/// 97.5 % quantile of Student's t, by Cornish and Fisher's expansion (Abramowitz and Stegun 26.7.5): within 1
/// % from 3 degrees of freedom up.
double student_t(double freedom) {
  const double z = 1.959963985, z3 = z * z * z, z5 = z3 * z * z, z7 = z5 * z * z;
  return z + (z3 + z) / (4 * freedom) + (5 * z5 + 16 * z3 + 3 * z) / (96 * freedom * freedom) +
         (3 * z7 + 19 * z5 + 17 * z3 - 15 * z) / (384 * freedom * freedom * freedom);
}

using SubjectTrials = std::map<int, std::vector<std::size_t>>;

/// How often each trial is drawn.
std::vector<int> drawn(const SubjectTrials& subjects, std::size_t trials, RandomStream& random) {
  std::vector<int> times(trials, 0);
  for (const auto& [subject, own] : subjects) {
    for (std::size_t k = 0; k < own.size(); ++k) {
      const auto pick = static_cast<std::size_t>(random.uniform() * static_cast<double>(own.size()));
      ++times[own[pick]];
    }
  }
  return times;
}

/// Mean and spread of a number over the draws that give it.
struct DrawSpread {
  double count = 0, mean = 0, squares = 0;
  void add(double value) {
    ++count;
    const double off = value - mean;
    mean += off / count;
    squares += off * (value - mean);
  }
};

void add_intervals(const std::vector<TrialEvidence>& evidence, const SubjectTrials& subjects,
                   std::uint64_t seed, ProfileFit& fit) {
  std::array<DrawSpread, pad_number_keys.size()> spreads;
  RandomStream random(seed);
  for (int draw = 0; draw < bootstrap_draws; ++draw) {
    const PadValues values = pad_numbers(evidence, drawn(subjects, evidence.size(), random));
    for (std::size_t k = 0; k < values.size(); ++k)
      if (values[k].refusal.empty()) spreads[k].add(values[k].value);
  }
  for (std::size_t k = 0; k < spreads.size(); ++k) {
    const double freedom = static_cast<double>(fit.values[k].trials) - static_cast<double>(subjects.size());
    constexpr double least_freedom = 3, most_missing = 0.05;
    if (!fit.values[k].refusal.empty() || freedom < least_freedom) continue;
    if (spreads[k].count < (1 - most_missing) * bootstrap_draws) continue;
    const double widened = std::sqrt(static_cast<double>(fit.values[k].trials) / freedom);
    const double reach =
        student_t(freedom) * widened * std::sqrt(spreads[k].squares / (spreads[k].count - 1));
    fit.interval[k] = {fit.values[k].value - reach, fit.values[k].value + reach};
  }
}

}  // namespace

ProfileFit fit_profile(const Measurement& measurement, std::uint64_t seed) {
  std::vector<TrialEvidence> evidence;
  SubjectTrials subjects;
  for (const MeasuredTrial& trial : measurement.trials) {
    subjects[trial.subject].push_back(evidence.size());
    evidence.push_back(trial_evidence(trial, stick_segments(trial)));
  }
  ProfileFit fit;
  fit.subjects = subjects.size();
  fit.trials = evidence.size();
  fit.values = pad_numbers(evidence, std::vector<int>(evidence.size(), 1));
  if (evidence.empty()) {
    for (PadValue& value : fit.values)
      value.refusal =
          measurement.without_force.empty() ? "no trial has contact" : measurement.without_force.front();
  }
  if (!evidence.empty()) add_intervals(evidence, subjects, seed, fit);
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
