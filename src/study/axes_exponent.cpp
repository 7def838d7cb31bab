#include "study/axes_exponent.hpp"

#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "study/likely_exponents.hpp"
#include "study/sample_noise.hpp"
#include "study/spring_fit.hpp"

namespace fingerpad {
namespace {

using AlikeTrials = std::vector<std::vector<OwnNumber>>;

/// Stiffnesses of trials that differ by load and chance alone.
AlikeTrials alike_stiffnesses(const std::vector<TrialEvidence>& trials) {
  std::map<std::tuple<int, long, std::size_t>, std::vector<OwnNumber>> parted;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    const TrialEvidence& trial = trials[i];
    for (const std::size_t axis : {std::size_t{0}, std::size_t{1}}) {
      const std::optional<double> own = own_stiffness(trial, axis);
      if (!own || !(*own > 0) || (trial.has_direction && !pushes_along(trial, axis))) continue;
      parted[{trial.subject, std::lround(trial.inclination_deg / 10), axis}].push_back(
          {i, *own, trial.stick_log_load / static_cast<double>(trial.stick_samples)});
    }
  }
  AlikeTrials found;
  for (auto& [kind, alike] : parted)
    if (alike.size() > 1) found.push_back(std::move(alike));
  return found;
}

/// How far a slope through alike trials may be off, by how they lie about it.
struct SlopeSpread {
  std::vector<double> offs;  ///< of ln(stiffness), about the median of trials that are alike
  double loads_2 = 0;        ///< sum of squares of ln(n) about their means
  std::set<std::size_t> trials;

  SlopeSpread(const AlikeTrials& groups, double slope) {
    for (const std::vector<OwnNumber>& group : groups) {
      std::vector<double> levels;
      double mean = 0;
      for (const OwnNumber& own : group) {
        levels.push_back(std::log(own.value) - slope * own.log_load);
        mean += own.log_load / static_cast<double>(group.size());
        trials.insert(own.trial);
      }
      const double level = median_of(levels);
      for (std::size_t k = 0; k < group.size(); ++k) {
        offs.push_back(std::abs(levels[k] - level));
        loads_2 += std::pow(group[k].log_load - mean, 2);
      }
    }
  }
  /// @param free  how many values are beyond those that groups and slope take
  double deviation(double free) const {
    constexpr double per_mad = 1 / 0.6745, of_median = 1.25;  // a mean's is 1
    constexpr double axes = 2;                                // of one trial, whose stiffnesses are off alike
    const auto count = static_cast<double>(offs.size());
    return of_median * per_mad * median_of(offs) * std::sqrt(count / free * axes / loads_2);
  }
};

}  // namespace

std::optional<double> own_stiffness(const TrialEvidence& trial, std::size_t axis) {
  const SpringSums &sums = trial.spring[axis], &other = trial.spring[1 - axis];
  if (!(sums(spring_straight, spring_straight) > 0.1 * other(spring_straight, spring_straight)) ||
      trial.stick_samples < 20)
    return std::nullopt;
  return sums(spring_straight, spring_straight) / sums(spring_position, spring_straight);
}

std::optional<AxesExponent> axes_exponent(const std::vector<TrialEvidence>& trials, double about) {
  constexpr double surely = 4, least = 0.1, most = 2, fewest_free = 4, least_loads_2 = 0.1;
  const AlikeTrials groups = alike_stiffnesses(trials);
  const std::optional<double> slope = median_slope(groups);
  if (!slope) return std::nullopt;
  const SlopeSpread spread(groups, *slope);
  const double free = static_cast<double>(spread.offs.size()) - static_cast<double>(groups.size()) - 1;
  if (free < fewest_free || spread.loads_2 < least_loads_2) return std::nullopt;
  const AxesExponent found{about - *slope, spread.deviation(free), spread.trials.size()};
  const double size = std::abs(found.value);
  if (!(size > surely * found.deviation) || !(size > least) || size > most) return std::nullopt;
  return found;
}

}  // namespace fingerpad
