#include "study/speed_step.hpp"

#include <algorithm>
#include <cmath>

#include "study/trial_evidence.hpp"

namespace fingerpad {
namespace {

constexpr double slowest_m_per_s = 5e-3;

/// What slips of a trial between two speeds.
struct SlipBetween {
  double ratio = 0, samples = 0;
  SlipBetween& operator+=(const SlipBetween& other) {
    ratio += other.ratio;
    samples += other.samples;
    return *this;
  }
};

SlipBetween slip_between(const SlipBySpeed& slip, std::size_t from, std::size_t to) {
  SlipBetween sum;
  for (std::size_t bin = from; bin < std::min(to, SlipBySpeed::bins); ++bin)
    sum += {slip.ratio[bin], slip.samples[bin]};
  return sum;
}

/// The mean rise from above to below, each trial by how well it tells it.
struct MeanRise {
  double rises = 0, weights = 0;
  long below = 0, trials = 0;

  void add(const SlipBetween& slow, const SlipBetween& fast, int times) {
    if (!(slow.samples > 0) || !(fast.samples > 0) || times == 0) return;
    const double weight = times * slow.samples * fast.samples / (slow.samples + fast.samples);
    rises += weight * (slow.ratio / slow.samples - fast.ratio / fast.samples);
    weights += weight;
    below += times * static_cast<long>(slow.samples);
    trials += times;
  }
  double mean() const noexcept { return rises / weights; }
};

/// Whether friction rises at the bin's speed, and not over a wide range about it.
bool is_sharp_at(const std::vector<TrialEvidence>& trials, const std::vector<int>& times, std::size_t bin,
                 double rise) {
  constexpr double most_of_it = 0.7;
  constexpr std::size_t near = 8;  // bins: a fifth
  MeanRise close;
  for (std::size_t i = 0; i < trials.size(); ++i)
    close.add(slip_between(trials[i].slip_by_speed, bin > near ? bin - near : 0, bin),
              slip_between(trials[i].slip_by_speed, bin, bin + near), times[i]);
  return close.weights > 0 && close.mean() > most_of_it * rise;
}

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

std::optional<SpeedStep> speed_step(const std::vector<TrialEvidence>& trials, const std::vector<int>& times) {
  constexpr long fewest = 50;
  std::vector<SlipBetween> all, slower(trials.size());
  for (const TrialEvidence& trial : trials)
    all.push_back(slip_between(trial.slip_by_speed, 0, SlipBySpeed::bins));
  std::optional<SpeedStep> best;
  std::size_t best_bin = 0;
  double most = 0;
  for (std::size_t bin = 1; bin < SlipBySpeed::bins; ++bin) {
    MeanRise sum;
    for (std::size_t i = 0; i < trials.size(); ++i) {
      slower[i] += slip_between(trials[i].slip_by_speed, bin - 1, bin);
      sum.add(slower[i], {all[i].ratio - slower[i].ratio, all[i].samples - slower[i].samples}, times[i]);
    }
    if (sum.below < fewest || !(sum.rises > 0) || !(sum.rises * sum.rises / sum.weights > most)) continue;
    most = sum.rises * sum.rises / sum.weights;
    best = {SlipBySpeed::speed_m_per_s(bin), sum.mean(), false, sum.below, sum.trials};
    best_bin = bin;
  }
  if (best) best->is_sharp = is_sharp_at(trials, times, best_bin, best->rise);
  return best;
}

}  // namespace fingerpad
