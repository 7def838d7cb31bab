#include "study/axis_numbers.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "study/spring_fit.hpp"

namespace fingerpad {
namespace {

constexpr double assumed_mu_static = 0.3;  // a profile's default

/// The stiffness over all pushed directions, where axes are not known.
PadValue plain_stiffness(const std::vector<TrialEvidence>& trials, const std::vector<int>& times) {
  std::map<int, std::pair<double, double>> subjects;
  PadValue found;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    const SpringSums both = trials[i].spring[0] + trials[i].spring[1];
    if (times[i] == 0 || trials[i].stick_samples == 0 || !(both(spring_straight, spring_straight) > 0))
      continue;
    auto& [reach, spread] = subjects[trials[i].subject];
    reach += times[i] * both(spring_position, spring_straight);
    spread += times[i] * both(spring_straight, spring_straight);
    found.samples += times[i] * trials[i].stick_samples;
    found.trials += times[i];
  }
  for (const auto& [subject, sums] : subjects)
    found.value += sums.second / sums.first / static_cast<double>(subjects.size());
  if (!(found.value > 0)) found.refusal = "no stretch of stick was found";
  return found;
}

/// A number that rests on one axis' stick.
PadValue of_axis(const SpringFit& fit, double value, const std::string& refusal) {
  return {value, fit.samples, fit.trials, refusal,
          refusal.empty()   ? RefusalReason::other
          : fit.samples > 0 ? RefusalReason::one_angle
                            : RefusalReason::not_pushed};
}

/// Where a number of one axis stands.
struct AxisNumbers {
  PadNumber axis, slope, stiffness, linearity, cubic_share, hysteresis_area;
};
constexpr AxisNumbers axis_numbers[] = {
    {PadNumber::lateral_axis, PadNumber::lateral_slope, PadNumber::stick_stiffness,
     PadNumber::lateral_linearity, PadNumber::lateral_cubic_share, PadNumber::lateral_hysteresis_area},
    {PadNumber::longitudinal_axis, PadNumber::longitudinal_slope, PadNumber::longitudinal_stiffness,
     PadNumber::longitudinal_linearity, PadNumber::longitudinal_cubic_share,
     PadNumber::longitudinal_hysteresis_area},
};

/// The spring as it was fitted about a bend, at an end that may be another.
struct FittedSpring {
  double reach = 0;        ///< over A, at the end
  double cubic_share = 0;  ///< from what the reach is short of that of the first slope
};

FittedSpring fitted_spring(const SpringBend& bend, double share_left, double mu_static) {
  const Vec2 end = bend.at(mu_static), begin = bend.at(0);
  const double secant = end[0] + share_left * end[1], slope = begin[0] + share_left * begin[1];
  return {mu_static * secant, 1 - secant / slope};
}

void add_axis(const SpringFit& fit, const SpringBend& bend, const AxisNumbers& numbers, PadValues& found) {
  const PadValue& mu_static = value_of(found, PadNumber::mu_static);
  const bool has_limit = mu_static.refusal.empty();
  const double mu = has_limit ? mu_static.value : assumed_mu_static;
  const FittedSpring spring = fitted_spring(bend, fit.shape.share_left, mu);
  const double axis_m = has_limit ? fit.compliance45_m * spring.reach : fit.straight45_m * mu;
  const std::string no_limit = "where the spring ends is not known, as mu_static is not";
  const std::string shape_refusal = has_limit ? fit.shape_refusal : no_limit,
                    loop_refusal = has_limit ? fit.hysteresis_refusal : no_limit;
  value_of(found, numbers.axis) = of_axis(fit, axis_m, fit.axis_refusal);
  value_of(found, numbers.slope) = of_axis(fit, fit.slope_per_deg, fit.slope_refusal);
  value_of(found, numbers.stiffness) = of_axis(fit, mu / axis_m, fit.axis_refusal);
  value_of(found, numbers.linearity) = of_axis(fit, fit.linearity, fit.shape_refusal);
  value_of(found, numbers.cubic_share) = of_axis(fit, spring.cubic_share, shape_refusal);
  value_of(found, numbers.hysteresis_area) = of_axis(fit, 4 * fit.shape.hysteresis_m * mu, loop_refusal);
}

}  // namespace

void add_axes(const std::vector<TrialEvidence>& trials, const std::vector<int>& times,
              const std::array<SpringBend, 2>& bend, PadValues& found) {
  for (int axis = 0; axis < 2; ++axis)
    add_axis(fit_spring(trials, times, axis), bend[static_cast<std::size_t>(axis)], axis_numbers[axis],
             found);
  const bool has_direction =
      std::any_of(trials.begin(), trials.end(), [](const TrialEvidence& t) { return t.has_direction; });
  if (!has_direction) value_of(found, PadNumber::stick_stiffness) = plain_stiffness(trials, times);
}

void take_bends(const PadValues& found, EvidencePoint& next) {
  constexpr double most_bent = 0.9;
  const PadValue& mu_static = value_of(found, PadNumber::mu_static);
  if (!mu_static.refusal.empty()) return;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const PadValue& share = value_of(found, axis_numbers[axis].cubic_share);
    next.bend[axis].mu_static = mu_static.value;
    if (share.refusal.empty()) next.bend[axis].cubic_share = std::clamp(share.value, 0.0, most_bent);
  }
}

}  // namespace fingerpad
