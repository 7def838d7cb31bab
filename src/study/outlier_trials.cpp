#include "study/outlier_trials.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "study/axes_exponent.hpp"
#include "study/likely_exponents.hpp"
#include "study/press_fit.hpp"
#include "study/sample_noise.hpp"
#include "study/spring_fit.hpp"

namespace fingerpad {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

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
      return own_stiffness(trial, 0).value_or(nothing);
    case PadNumber::longitudinal_stiffness:
      return own_stiffness(trial, 1).value_or(nothing);
    case PadNumber::normal_stiffness:
      return press_exponent ? 1 / (own_depth_at_1_n_m(trial).value_or(nothing) * *press_exponent) : nothing;
    default:
      return nothing;
  }
}

/// The mean of ln n where a trial tells a number; `nothing` where that is not known.
double own_log_load(const TrialEvidence& trial, PadNumber number) {
  const auto mean = [](double sum, long count) {
    return count > 0 ? sum / static_cast<double>(count) : nothing;
  };
  switch (number) {
    case PadNumber::mu_static:
      return mean(trial.rupture_log_load, trial.ruptures);
    case PadNumber::mu_dynamic:
    case PadNumber::v_min:
      return mean(trial.slip_log_load, trial.slip_samples);
    case PadNumber::normal_stiffness:
      return mean(trial.press_log_load, trial.press_groups);
    default:
      return mean(trial.stick_log_load, trial.stick_samples);
  }
}

/// Whether a fit takes what the trial says of the number.
bool is_counted(const TrialEvidence& trial, PadNumber number) {
  if (number == PadNumber::stick_stiffness) return !trial.has_direction || pushes_along(trial, 0);
  if (number == PadNumber::longitudinal_stiffness) return !trial.has_direction || pushes_along(trial, 1);
  return true;
}

/// The angle at which a number holds, of those that change with it: trials of others are not alike.
int angle_of(const TrialEvidence& trial, PadNumber number) {
  const bool by_angle = number == PadNumber::stick_stiffness || number == PadNumber::longitudinal_stiffness ||
                        number == PadNumber::normal_stiffness;
  return by_angle ? static_cast<int>(std::lround(trial.inclination_deg / 10)) : 0;
}

/// What one subject's trials say of a number, those of each angle by themselves.
using Groups = std::vector<std::vector<OwnNumber>>;

std::map<int, Groups> groups_of_subjects(const std::vector<TrialEvidence>& evidence, PadNumber number,
                                         const std::optional<double>& press_exponent) {
  std::map<int, std::map<int, std::vector<OwnNumber>>> parted;
  for (std::size_t i = 0; i < evidence.size(); ++i) {
    const double own = own_number(evidence[i], number, press_exponent);
    if (std::isnan(own)) continue;
    parted[evidence[i].subject][angle_of(evidence[i], number)].push_back(
        {i, own, own_log_load(evidence[i], number)});
  }
  std::map<int, Groups> found;
  for (auto& [subject, angles] : parted)
    for (auto& [angle, trials] : angles) found[subject].push_back(std::move(trials));
  return found;
}

/// A trial that is off, by its place in its group, and what is usual at its load.
using Off = std::map<std::size_t, double>;

/// Of three or four trials the one that is far off by Dixon's test (two-sided, 1 %: Rorabacher 1991, table
/// 2): its gap to the nearest is so much of the whole range. Of three trials the two others must agree to 0.6
/// % of that gap, of four the three others to 8 %.
Off off_of_few(const std::vector<double>& values, double least_share) {
  const double least_gap = values.size() == 3 ? 0.994 : 0.926;
  std::vector<double> sorted = values;
  std::sort(sorted.begin(), sorted.end());
  const std::size_t last = sorted.size() - 1;
  const double range = sorted[last] - sorted[0], below = sorted[1] - sorted[0],
               above = sorted[last] - sorted[last - 1];
  if (!(std::max(below, above) > least_gap * range)) return {};
  const double odd = below > above ? sorted[0] : sorted[last];
  if (below > above) std::rotate(sorted.begin(), sorted.begin() + 1, sorted.end());
  sorted.pop_back();
  const double usual = quantile(sorted, 0.5);
  if (!(std::abs(odd - usual) > least_share * std::abs(usual))) return {};
  return {{static_cast<std::size_t>(std::find(values.begin(), values.end(), odd) - values.begin()), usual}};
}

Off off_of_many(const std::vector<double>& values, double least_share) {
  constexpr double deviations = 5;
  const double usual = quantile(values, 0.5);
  std::vector<double> offs;
  offs.reserve(values.size());
  for (const double value : values) offs.push_back(std::abs(value - usual));
  const double most = std::max(deviations * quantile(offs, 0.5) / 0.6745, least_share * std::abs(usual));
  Off off;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (offs[i] > most) off[i] = usual;
  return off;
}

/// Those of a group that are off where its number goes with n^exponent.
Off off_at(const std::vector<OwnNumber>& group, double exponent, double least_share) {
  constexpr std::size_t fewest = 3, fewest_of_many = 5;
  if (group.size() < fewest) return {};
  std::vector<double> loads, values;
  for (const OwnNumber& own : group)
    if (!std::isnan(own.log_load)) loads.push_back(own.log_load);
  const double log_load = median_of(loads);
  values.reserve(group.size());
  for (const OwnNumber& own : group) values.push_back(own.value / own.times_that_at(log_load, exponent));
  Off off =
      group.size() < fewest_of_many ? off_of_few(values, least_share) : off_of_many(values, least_share);
  for (auto& [place, usual] : off) usual *= group[place].times_that_at(log_load, exponent);
  return off;
}

/// What is usual at a trial's load where it is off by an exponent.
std::optional<double> usual_if_off(const std::vector<OwnNumber>& group, std::size_t place, double exponent,
                                   double least_share) {
  const Off off = off_at(group, exponent, least_share);
  const auto found = off.find(place);
  return found == off.end() ? std::nullopt : std::optional(found->second);
}

/// Those of a group that are off by an exponent that all trials leave likely: the others are not asked about
/// one by one.
std::set<std::size_t> perhaps_off(const std::vector<std::vector<OwnNumber>>& groups,
                                  const std::vector<OwnNumber>& group, double least_share) {
  const ExponentRange likely = likely_exponents(groups);
  std::set<std::size_t> places;
  for (const double exponent : {likely.least, median_slope(groups).value_or(0), likely.most})
    for (const auto& [place, usual] : off_at(group, std::clamp(exponent, -1.0, 1.0), least_share))
      places.insert(place);
  return places;
}

}  // namespace

std::vector<OutlierTrial> outlier_trials(const std::vector<std::string>& names,
                                         const std::vector<TrialEvidence>& evidence,
                                         const std::optional<double>& press_exponent) {
  std::vector<OutlierTrial> found;
  for (const PadNumber number :
       {PadNumber::mu_static, PadNumber::mu_dynamic, PadNumber::v_min, PadNumber::stick_stiffness,
        PadNumber::longitudinal_stiffness, PadNumber::normal_stiffness}) {
    const double least_share = number == PadNumber::v_min ? 0.25 : 0.1;  // it rests on a few ends of slip
    for (const auto& [subject, groups] : groups_of_subjects(evidence, number, press_exponent)) {
      for (const std::vector<OwnNumber>& group : groups) {
        for (const std::size_t place : perhaps_off(groups, group, least_share)) {
          const OwnNumber& own = group[place];
          const ExponentRange likely = exponents_beside(groups, own.trial);
          const auto by_least = usual_if_off(group, place, likely.least, least_share),
                     by_most = usual_if_off(group, place, likely.most, least_share);
          // Off to one side by the one and to the other by the other, some exponent in between explains it.
          if (!by_least || !by_most || (own.value > *by_least) != (own.value > *by_most)) continue;
          found.push_back({own.trial, names[own.trial], number, own.value, (*by_least + *by_most) / 2,
                           is_counted(evidence[own.trial], number)});
        }
      }
    }
  }
  std::sort(found.begin(), found.end(), [](const OutlierTrial& a, const OutlierTrial& b) {
    return std::pair(a.trial, a.number) < std::pair(b.trial, b.number);
  });
  return found;
}

}  // namespace fingerpad
