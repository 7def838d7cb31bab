#include "study/outlier_trials.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "study/press_fit.hpp"
#include "study/sample_noise.hpp"

namespace fingerpad {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// The stiffness that a trial's stick has along an axis.
double own_stiffness(const TrialEvidence& trial, std::size_t axis) {
  const SpringSums &sums = trial.spring[axis], &other = trial.spring[1 - axis];
  if (!(sums(spring_straight, spring_straight) > 0.1 * other(spring_straight, spring_straight)) ||
      trial.stick_samples < 20)
    return nothing;
  return sums(spring_straight, spring_straight) / sums(spring_position, spring_straight);
}

/// What a trial alone says of a number; `nothing` where it says little.
double own_number(const TrialEvidence& trial, PadNumber number, const std::optional<double>& press_exponent) {
  const auto mean = [](double sum, long count, long fewest) {
    return count < fewest ? nothing : sum / static_cast<double>(count);
  };
  switch (number) {
    case PadNumber::mu_static:
      return mean(trial.rupture_ratio, trial.ruptures, 3);
    case PadNumber::mu_dynamic:
      return mean(trial.slip_ratio, trial.slip_samples, 100);
    case PadNumber::v_min:
      return mean(trial.stop_speed_m_per_s, trial.stops, 2);
    case PadNumber::stick_stiffness:
      return own_stiffness(trial, 0);
    case PadNumber::longitudinal_stiffness:
      return own_stiffness(trial, 1);
    case PadNumber::normal_stiffness:
      return press_exponent ? 1 / (own_depth_at_1_n_m(trial).value_or(nothing) * *press_exponent) : nothing;
    default:
      return nothing;
  }
}

/// Trials that are alike but for chance: of one subject, of stiffnesses at one angle too.
using Alike = std::pair<int, int>;

Alike alike(const TrialEvidence& trial, PadNumber number) {
  const bool by_angle = number == PadNumber::stick_stiffness || number == PadNumber::longitudinal_stiffness ||
                        number == PadNumber::normal_stiffness;
  return {trial.subject, by_angle ? static_cast<int>(std::lround(trial.inclination_deg / 10)) : 0};
}

/// A trial's place in the evidence, and what it alone says.
using OwnNumber = std::pair<std::size_t, double>;

/// What the others say, of three or four trials one of which is far off by Dixon's test (two-sided, 1 %:
/// Rorabacher 1991, table 2): its gap to the nearest is so much of the whole range. Of three trials the two
/// others must agree to 0.6 % of that gap, of four the three others to 8 %.
struct FewOutlier {
  std::size_t trial;
  double value, usual;
};

std::optional<FewOutlier> outlier_of_few(std::vector<OwnNumber> trials, double least_share) {
  const double least_gap = trials.size() == 3 ? 0.994 : 0.926;
  std::sort(trials.begin(), trials.end(),
            [](const OwnNumber& a, const OwnNumber& b) { return a.second < b.second; });
  const std::size_t last = trials.size() - 1;
  const double range = trials[last].second - trials[0].second, below = trials[1].second - trials[0].second,
               above = trials[last].second - trials[last - 1].second;
  const bool is_first = below > above;
  if (!(std::max(below, above) > least_gap * range)) return std::nullopt;
  if (is_first) std::rotate(trials.begin(), trials.begin() + 1, trials.end());
  std::vector<double> others;
  for (std::size_t i = 0; i < last; ++i) others.push_back(trials[i].second);
  const double usual = quantile(others, 0.5);
  if (!(std::abs(trials[last].second - usual) > least_share * std::abs(usual))) return std::nullopt;
  return FewOutlier{trials[last].first, trials[last].second, usual};
}

}  // namespace

std::vector<OutlierTrial> outlier_trials(const std::vector<std::string>& names,
                                         const std::vector<TrialEvidence>& evidence,
                                         const std::optional<double>& press_exponent) {
  constexpr std::size_t fewest = 3, fewest_of_many = 5;
  constexpr double deviations = 5;
  std::vector<OutlierTrial> found;
  for (const PadNumber number :
       {PadNumber::mu_static, PadNumber::mu_dynamic, PadNumber::v_min, PadNumber::stick_stiffness,
        PadNumber::longitudinal_stiffness, PadNumber::normal_stiffness}) {
    const double least_share = number == PadNumber::v_min ? 0.25 : 0.1;  // it rests on a few ends of slip
    std::map<Alike, std::vector<OwnNumber>> groups;
    for (std::size_t i = 0; i < evidence.size(); ++i) {
      const double own = own_number(evidence[i], number, press_exponent);
      if (!std::isnan(own)) groups[alike(evidence[i], number)].emplace_back(i, own);
    }
    for (const auto& [key, trials] : groups) {
      if (trials.size() < fewest) continue;
      if (trials.size() < fewest_of_many) {
        if (const auto one = outlier_of_few(trials, least_share))
          found.push_back({one->trial, names[one->trial], number, one->value, one->usual});
        continue;
      }
      std::vector<double> values, offs;
      for (const auto& [trial, value] : trials) values.push_back(value);
      const double usual = quantile(values, 0.5);
      for (const double value : values) offs.push_back(std::abs(value - usual));
      const double most = std::max(deviations * quantile(offs, 0.5) / 0.6745, least_share * std::abs(usual));
      for (const auto& [trial, value] : trials) {
        if (std::abs(value - usual) > most) found.push_back({trial, names[trial], number, value, usual});
      }
    }
  }
  std::sort(found.begin(), found.end(), [](const OutlierTrial& a, const OutlierTrial& b) {
    return std::pair(a.trial, a.number) < std::pair(b.trial, b.number);
  });
  return found;
}

}  // namespace fingerpad
