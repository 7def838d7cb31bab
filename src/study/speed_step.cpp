#include "study/speed_step.hpp"

#include <algorithm>
#include <cmath>

#include "study/trial_evidence.hpp"

namespace fingerpad {
namespace {

constexpr double slowest_m_per_s = 5e-3, bin_width = 0.025;

/// Sums of a trial's slip below a speed and in all.
struct BelowAndAll {
  double ratio = 0, samples = 0, all_ratio = 0, all_samples = 0;
};

}  // namespace

void SlipBySpeed::add(double speed_m_per_s, double along) {
  const double at = std::log(speed_m_per_s / slowest_m_per_s) / bin_width;
  if (!(at >= 0)) return;
  const auto bin = std::min(static_cast<std::size_t>(at), bins - 1);
  ratio[bin] += along;
  ++samples[bin];
}

double SlipBySpeed::speed_m_per_s(std::size_t bin) {
  return slowest_m_per_s * std::exp(bin_width * static_cast<double>(bin));
}

std::optional<SpeedStep> speed_step(const std::vector<TrialEvidence>& trials) {
  constexpr double fewest = 50;
  std::vector<BelowAndAll> sums(trials.size());
  for (std::size_t i = 0; i < trials.size(); ++i) {
    for (std::size_t bin = 0; bin < SlipBySpeed::bins; ++bin) {
      sums[i].all_ratio += trials[i].slip_by_speed.ratio[bin];
      sums[i].all_samples += trials[i].slip_by_speed.samples[bin];
    }
  }
  std::optional<SpeedStep> best;
  double most = 0;
  for (std::size_t bin = 1; bin < SlipBySpeed::bins; ++bin) {
    double below = 0, weights = 0, rises = 0;
    for (std::size_t i = 0; i < trials.size(); ++i) {
      BelowAndAll& sum = sums[i];
      sum.ratio += trials[i].slip_by_speed.ratio[bin - 1];
      sum.samples += trials[i].slip_by_speed.samples[bin - 1];
      const double above = sum.all_samples - sum.samples;
      if (!(sum.samples > 0) || !(above > 0)) continue;
      const double weight = sum.samples * above / sum.all_samples;
      rises += weight * (sum.ratio / sum.samples - (sum.all_ratio - sum.ratio) / above);
      weights += weight;
      below += sum.samples;
    }
    if (below < fewest || !(rises > 0) || !(rises * rises / weights > most)) continue;
    most = rises * rises / weights;
    best = {SlipBySpeed::speed_m_per_s(bin), rises / weights};
  }
  return best;
}

}  // namespace fingerpad
