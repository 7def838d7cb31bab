#include "study/pad_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "study/stick_axis_fit.hpp"
#include "study/vibration_peak.hpp"

namespace fingerpad {
namespace {

constexpr double assumed_mu_static = 0.3;  // a profile's default

using EvidenceSum = double TrialEvidence::*;
using EvidenceCount = long TrialEvidence::*;

/// The mean of the subjects' means. A trial's weight grows with its samples up to `enough` and hardly beyond:
/// more of them say the same trial again, and a trial of low mu_s ruptures more often.
PadValue subjects_mean(const std::vector<TrialEvidence>& trials, const std::vector<int>& times,
                       EvidenceSum sum, EvidenceCount count, const char* refusal) {
  constexpr double enough = 10;
  std::map<int, std::pair<double, double>> subjects;
  PadValue found;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    const long here = times[i] * trials[i].*count;
    if (here == 0) continue;
    auto& [total, weight] = subjects[trials[i].subject];
    const auto count_here = static_cast<double>(trials[i].*count);
    const double own = times[i] * count_here / (count_here + enough);
    total += own * trials[i].*sum / count_here;
    weight += own;
    found.samples += here;
    found.trials += times[i];
  }
  for (const auto& [subject, mean] : subjects)
    found.value += mean.first / mean.second / static_cast<double>(subjects.size());
  if (subjects.empty()) found.refusal = refusal;
  return found;
}

/// The stiffness over all pushed directions, where axes are not known.
PadValue plain_stiffness(const std::vector<TrialEvidence>& trials, const std::vector<int>& times) {
  std::map<int, std::pair<double, double>> subjects;
  PadValue found;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    if (times[i] == 0 || trials[i].stick_samples == 0 || !(trials[i].spread_m2.sum() > 0)) continue;
    auto& [pull, spread] = subjects[trials[i].subject];
    pull += times[i] * trials[i].pull_m.sum();
    spread += times[i] * trials[i].spread_m2.sum();
    found.samples += times[i] * trials[i].stick_samples;
    found.trials += times[i];
  }
  for (const auto& [subject, sums] : subjects)
    found.value += sums.first / sums.second / static_cast<double>(subjects.size());
  if (!(found.value > 0)) found.refusal = "no stretch of stick was found";
  return found;
}

PadValue of_axis(const StickAxisFit& fit, double value, const std::string& refusal) {
  return {value, fit.samples, fit.trials, refusal};
}

}  // namespace

PadValues pad_numbers(const std::vector<TrialEvidence>& trials, const std::vector<int>& times) {
  PadValues found;
  for (PadValue& value : found) value.refusal = "not fitted";
  const auto at = [&](PadNumber number) -> PadValue& { return found[static_cast<std::size_t>(number)]; };
  at(PadNumber::mu_static) = subjects_mean(trials, times, &TrialEvidence::rupture_ratio,
                                           &TrialEvidence::ruptures, "no rupture from stick was found");
  at(PadNumber::mu_dynamic) = subjects_mean(trials, times, &TrialEvidence::slip_ratio,
                                            &TrialEvidence::slip_samples, "no slip was found");
  at(PadNumber::v_min) = subjects_mean(trials, times, &TrialEvidence::stop_speed_m_per_s,
                                       &TrialEvidence::stops, "no slip that ends in stick was found");
  const double mu_static =
      at(PadNumber::mu_static).refusal.empty() ? at(PadNumber::mu_static).value : assumed_mu_static;
  const PadNumber axes[] = {PadNumber::lateral_axis, PadNumber::longitudinal_axis};
  const PadNumber slopes[] = {PadNumber::lateral_slope, PadNumber::longitudinal_slope};
  for (int axis = 0; axis < 2; ++axis) {
    const StickAxisFit fit = fit_stick_axis(trials, times, axis);
    at(axes[axis]) = of_axis(fit, mu_static * fit.compliance45_m, fit.axis_refusal);
    at(slopes[axis]) = of_axis(fit, fit.slope_per_deg, fit.slope_refusal);
    if (axis > 0) continue;
    at(PadNumber::stick_stiffness) =
        fit.axis_refusal.empty() ? of_axis(fit, 1 / fit.compliance45_m, "") : plain_stiffness(trials, times);
  }
  at(PadNumber::vibration) = vibration_peak(trials, times);
  return found;
}

}  // namespace fingerpad
