#include "study/stick_axis_fit.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace fingerpad {
namespace {

constexpr double least_angle_span_deg = 10;

/// A trial's 1/K at its angle. The weight is what it moved along the axis: the inverse of its variance.
struct AxisPoint {
  double from45_deg, compliance_m, weight;
};

/// A subject's own line of 1/K over the angle.
struct SubjectLine {
  std::vector<AxisPoint> points;
  double at45_m = 0;
  bool has_slope = false, holds = false;
};

void fit_line(SubjectLine& line) {
  double weights = 0, mean_x = 0, mean_y = 0;
  double least = line.points.front().from45_deg, most = least;
  for (const AxisPoint& p : line.points) {
    weights += p.weight;
    mean_x += p.weight * p.from45_deg;
    mean_y += p.weight * p.compliance_m;
    least = std::min(least, p.from45_deg);
    most = std::max(most, p.from45_deg);
  }
  mean_x /= weights;
  mean_y /= weights;
  for (AxisPoint& p : line.points) p.weight /= weights;
  line.has_slope = most - least >= least_angle_span_deg;
  line.at45_m = mean_y;
  line.holds = line.has_slope || std::abs(mean_x) <= least_angle_span_deg;
  if (!line.has_slope) return;
  double xx = 0, xy = 0;
  for (const AxisPoint& p : line.points) {
    xx += p.weight * (p.from45_deg - mean_x) * (p.from45_deg - mean_x);
    xy += p.weight * (p.from45_deg - mean_x) * (p.compliance_m - mean_y);
  }
  line.at45_m = mean_y - xy / xx * mean_x;
  line.holds = line.at45_m > 0;
}

std::map<int, SubjectLine> subject_lines(const std::vector<TrialEvidence>& trials,
                                         const std::vector<int>& times, int axis, StickAxisFit& fit) {
  std::map<int, SubjectLine> lines;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    const TrialEvidence& trial = trials[i];
    // A trial pushed along the other axis has only noise along this one.
    if (times[i] == 0 || !trial.has_direction || !(trial.spread_m2[axis] > 0.01 * trial.spread_m2.sum()) ||
        !(trial.pull_m[axis] > 0))
      continue;
    fit.samples += times[i] * trial.stick_samples;
    fit.trials += times[i];
    lines[trial.subject].points.push_back({trial.inclination_deg - 45,
                                           trial.spread_m2[axis] / trial.pull_m[axis],
                                           times[i] * trial.spread_m2[axis]});
  }
  return lines;
}

}  // namespace

StickAxisFit fit_stick_axis(const std::vector<TrialEvidence>& trials, const std::vector<int>& times,
                            int axis) {
  StickAxisFit fit;
  std::map<int, SubjectLine> lines = subject_lines(trials, times, axis, fit);
  double held = 0, xx = 0, xy = 0;
  for (auto& [subject, line] : lines) {
    fit_line(line);
    if (!line.holds) continue;
    fit.compliance45_m += line.at45_m;
    ++held;
    if (!line.has_slope) continue;
    for (const AxisPoint& p : line.points) {
      xx += p.weight * p.from45_deg * p.from45_deg;
      xy += p.weight * p.from45_deg * (1 - p.compliance_m / line.at45_m);
    }
  }
  const bool has_direction =
      std::any_of(trials.begin(), trials.end(), [](const TrialEvidence& t) { return t.has_direction; });
  if (held > 0) {
    fit.compliance45_m /= held;
  } else {
    fit.axis_refusal = !has_direction  ? "columns dx, dy, dz missing: the finger's axes are not known"
                       : lines.empty() ? "no stick was pushed along this axis"
                                       : "one finger angle only, more than 10 degrees from 45";
  }
  if (xx > 0) {
    fit.slope_per_deg = xy / xx;
  } else {
    fit.slope_refusal = !has_direction  ? "columns dx, dy, dz missing: the finger's angle is not known"
                        : lines.empty() ? "no stick was pushed along this axis"
                                        : "one finger angle only; it takes some that differ by 10 degrees";
  }
  return fit;
}

}  // namespace fingerpad
