#include "study/vibration_peak.hpp"

#include <algorithm>
#include <cmath>

namespace fingerpad {
namespace {

/// The mean density of all windows of slip.
struct SlipDensity {
  std::vector<double> power;
  double step_hz = 0;
  PadValue found;
};

SlipDensity mean_density(const std::vector<TrialEvidence>& trials, const std::vector<int>& times) {
  SlipDensity mean;
  double rate_hz = 0;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    const TrialEvidence& trial = trials[i];
    if (times[i] == 0 || trial.pieces == 0) continue;
    if (rate_hz > 0 && std::abs(trial.rate_hz / rate_hz - 1) > 0.01) {
      mean.found.refusal = "trials have different rates";
      return mean;
    }
    rate_hz = trial.rate_hz;
    mean.power.resize(trial.power.size(), 0.0);
    for (std::size_t k = 0; k < mean.power.size(); ++k) mean.power[k] += times[i] * trial.power[k];
    mean.found.samples += times[i] * trial.pieces;
    mean.found.trials += times[i];
  }
  mean.step_hz = rate_hz / static_cast<double>(vibration_window(rate_hz));
  if (mean.found.trials == 0) mean.found.refusal = "no slip lasts for a window of its spectrum";
  return mean;
}

}  // namespace

PadValue vibration_peak(const std::vector<TrialEvidence>& trials, const std::vector<int>& times) {
  constexpr double lowest_hz = 20, reach_hz = 8, least_height = 3;
  SlipDensity mean = mean_density(trials, times);
  if (!mean.found.refusal.empty()) return mean.found;
  const auto first = static_cast<std::size_t>(std::ceil(lowest_hz / mean.step_hz));
  const auto end = static_cast<std::size_t>(0.9 * static_cast<double>(mean.power.size()));
  if (first + 8 > end) {
    mean.found.refusal = "the rate is too low to show a vibration";
    return mean.found;
  }
  const auto at = [&](std::size_t k) { return mean.power.begin() + static_cast<long>(k); };
  std::vector<double> sorted(at(first), at(end));
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<long>(sorted.size() / 2), sorted.end());
  const double floor = sorted[sorted.size() / 2];
  const auto peak = static_cast<std::size_t>(std::max_element(at(first), at(end)) - mean.power.begin());
  if (!(mean.power[peak] > least_height * floor)) {
    mean.found.refusal = "no frequency stands out of the spectrum of slip";
    return mean.found;
  }
  double centre_hz = static_cast<double>(peak) * mean.step_hz;
  for (int pass = 0; pass < 20; ++pass) {
    double weight = 0, sum = 0;
    for (std::size_t k = first; k < end; ++k) {
      const double hz = static_cast<double>(k) * mean.step_hz, off = (hz - centre_hz) / reach_hz;
      if (std::abs(off) >= 1) continue;
      // A window that ends softly: the centre moves on smoothly from bin to bin.
      const double share = (1 - off * off) * std::max(0.0, mean.power[k] - floor);
      weight += share;
      sum += share * hz;
    }
    if (weight > 0) centre_hz = sum / weight;
  }
  mean.found.value = centre_hz;
  return mean.found;
}

}  // namespace fingerpad
