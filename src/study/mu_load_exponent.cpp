#include "study/mu_load_exponent.hpp"

#include <cmath>
#include <map>

namespace fingerpad {
namespace {

/// One trial's slip: means of the ratio r and of L = ln(n/load), and sums of products about them; r as a
/// share of its mean.
struct TrialSlip {
  double samples = 0, ratio = 0, load = 0;
  double within_2 = 0;      ///< sum of (L - mean)^2
  double within_ratio = 0;  ///< sum of (L - mean) (r/mean - 1)
  double times = 1;

  bool sways() const noexcept {
    // Less than that may be the noise of the load.
    constexpr double least_sway = 0.03;  // standard deviation of ln n
    return within_2 > least_sway * least_sway * samples;
  }
};

using SubjectSlips = std::map<int, std::vector<TrialSlip>>;

SubjectSlips slips_of(const std::vector<TrialEvidence>& trials, const std::vector<int>* times) {
  SubjectSlips subjects;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    const TrialEvidence& trial = trials[i];
    if ((times != nullptr && (*times)[i] == 0) || trial.slip_samples == 0 || !(trial.slip_ratio > 0))
      continue;
    TrialSlip slip;
    slip.samples = static_cast<double>(trial.slip_samples);
    slip.ratio = trial.slip_ratio / slip.samples;
    slip.load = trial.slip_load / slip.samples;
    slip.within_2 = trial.slip_load_2 - slip.samples * slip.load * slip.load;
    slip.within_ratio = trial.slip_load_ratio / slip.ratio - slip.samples * slip.load;
    slip.times = times != nullptr ? (*times)[i] : 1;
    subjects[trial.subject].push_back(slip);
  }
  return subjects;
}

/// A line through the trials' means of a subject, by weight.
struct MeansLine {
  double load = 0, ratio = 0, weight = 0;
  double between_2 = 0, between_ratio = 0;  ///< sums about the means; the ratio as a share of its mean

  template <typename Weight>
  MeansLine(const std::vector<TrialSlip>& slips, const Weight& weight_of) {
    for (const TrialSlip& slip : slips) {
      const double own = weight_of(slip);
      weight += own;
      load += own * slip.load;
      ratio += own * slip.ratio;
    }
    load /= weight;
    ratio /= weight;
    for (const TrialSlip& slip : slips) {
      const double own = weight_of(slip), off = slip.load - load;
      between_2 += own * off * off;
      between_ratio += own * off * (slip.ratio / ratio - 1);
    }
  }
};

/// What is told of scatter, over all subjects.
struct ScatterSums {
  double own_exponents = 0, own_freedom = 0;  ///< of trials' exponents about their subject's, per sample
  double means = 0, samples = 0, means_freedom = 0, trials = 0;  ///< of trials' means about a line

  void add(const std::vector<TrialSlip>& slips) {
    double within_2 = 0, within_ratio = 0;
    for (const TrialSlip& slip : slips) {
      if (!slip.sways()) continue;
      within_2 += slip.within_2;
      within_ratio += slip.within_ratio;
    }
    for (const TrialSlip& slip : slips) {
      if (!slip.sways()) continue;
      const double off = slip.within_ratio - within_ratio / within_2 * slip.within_2;
      own_exponents += off * off / slip.within_2;
      ++own_freedom;
    }
    if (within_2 > 0) --own_freedom;
    const MeansLine line(slips, [](const TrialSlip& slip) { return slip.samples; });
    const bool has_slope = slips.size() > 2 && line.between_2 > 1e-6 * line.weight;
    const double slope = has_slope ? line.between_ratio / line.between_2 : 0;
    for (const TrialSlip& slip : slips) {
      const double off = slip.ratio / line.ratio - 1 - slope * (slip.load - line.load);
      means += slip.samples * off * off;
      samples += slip.samples;
      ++trials;
    }
    means_freedom += static_cast<double>(slips.size()) - (has_slope ? 2 : 1);
  }
};

}  // namespace

PadValue mu_load_exponent(const std::vector<TrialEvidence>& trials, const std::vector<int>& times,
                          double about, double scatter) {
  constexpr double least_spread = 0.1;  // standard deviation of ln n
  PadValue found;
  double exponents = 0, count = 0;
  const SubjectSlips subjects = slips_of(trials, &times);
  for (const auto& [subject, slips] : subjects) {
    double within_2 = 0, within_ratio = 0, samples = 0;
    for (const TrialSlip& slip : slips) {
      samples += slip.times * slip.samples;
      found.samples += std::lround(slip.times * slip.samples);
      found.trials += std::lround(slip.times);
      if (!slip.sways()) continue;
      within_2 += slip.times * slip.within_2;
      within_ratio += slip.times * slip.within_ratio;
    }
    const MeansLine all(slips, [](const TrialSlip& slip) { return slip.times * slip.samples; });
    if (!(within_2 + all.between_2 > least_spread * least_spread * samples)) continue;
    const MeansLine means(slips, [&](const TrialSlip& slip) {
      return slip.times * slip.samples / (1 + scatter * slip.samples);
    });
    exponents += about + (within_ratio + means.between_ratio) / (within_2 + means.between_2);
    ++count;
  }
  if (count > 0) found.value = exponents / count;
  if (subjects.empty()) found.refusal = "no slip was found";
  if (!subjects.empty() && count == 0)
    found.refusal = "the normal force hardly changes: it takes loads that differ by a tenth";
  return found;
}

double trial_scatter(const std::vector<TrialEvidence>& trials) {
  constexpr double fewest = 2;  // degrees of freedom
  ScatterSums sums;
  for (const auto& [subject, slips] : slips_of(trials, nullptr)) sums.add(slips);
  if (sums.own_freedom < fewest || sums.means_freedom < fewest || !(sums.own_exponents > 0)) return 0;
  const double of_sample = sums.own_exponents / sums.own_freedom;
  const double of_trial =
      (sums.means * sums.trials / sums.means_freedom - sums.trials * of_sample) / sums.samples;
  return std::max(0.0, of_trial / of_sample);
}

std::optional<double> mean_log_load(const std::vector<TrialEvidence>& trials) {
  std::map<int, std::pair<double, double>> subjects;
  for (const TrialEvidence& trial : trials) {
    if (trial.slip_samples == 0) continue;
    auto& [sum, samples] = subjects[trial.subject];
    sum += trial.slip_log_load;
    samples += static_cast<double>(trial.slip_samples);
  }
  if (subjects.empty()) return std::nullopt;
  double mean = 0;
  for (const auto& [subject, sums] : subjects)
    mean += sums.first / sums.second / static_cast<double>(subjects.size());
  return mean;
}

}  // namespace fingerpad
