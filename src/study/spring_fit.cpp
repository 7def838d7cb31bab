#include "study/spring_fit.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>

#include "study/spring_sums.hpp"

namespace fingerpad {
namespace {

constexpr double least_angle_span_deg = 10;

/// A trial that pushed along the axis.
struct PushedTrial {
  const SpringSums* sums;
  int subject;
  double from45_deg;
  double samples;  ///< of stick
  double weight;   ///< within its subject: what it moved along the axis, which is the inverse of its variance
  double compliance_m = 0;  ///< its own A
  double on_line_m = 0;     ///< of its subject's line
};

std::vector<PushedTrial> pushed_trials(const std::vector<TrialEvidence>& trials,
                                       const std::vector<int>& times, int axis, SpringFit& fit) {
  std::vector<PushedTrial> pushed;
  std::map<int, double> weights;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    const TrialEvidence& trial = trials[i];
    if (times[i] == 0 || !pushes_along(trial, static_cast<std::size_t>(axis))) continue;
    const SpringSums& sums = trial.spring[static_cast<std::size_t>(axis)];
    const double ratio2 = sums(spring_ratio, spring_ratio);
    fit.samples += times[i] * trial.stick_samples;
    fit.trials += times[i];
    pushed.push_back({&sums, trial.subject, trial.inclination_deg - 45,
                      static_cast<double>(trial.stick_samples), times[i] * ratio2});
    weights[trial.subject] += pushed.back().weight;
  }
  for (PushedTrial& trial : pushed) trial.weight /= weights[trial.subject];
  return pushed;
}

/// A subject's own line of A over the angle.
struct SubjectLine {
  double at45_m = 0, per_deg_m = 0;
  bool has_slope = false, holds = false;
};

SubjectLine line_of(const std::vector<PushedTrial>& trials, int subject) {
  SubjectLine line;
  double mean_x = 0, mean_y = 0, least = 1e9, most = -1e9, xx = 0, xy = 0;
  for (const PushedTrial& p : trials) {
    if (p.subject != subject) continue;
    mean_x += p.weight * p.from45_deg;
    mean_y += p.weight * p.compliance_m;
    least = std::min(least, p.from45_deg);
    most = std::max(most, p.from45_deg);
  }
  for (const PushedTrial& p : trials) {
    if (p.subject != subject) continue;
    xx += p.weight * (p.from45_deg - mean_x) * (p.from45_deg - mean_x);
    xy += p.weight * (p.from45_deg - mean_x) * (p.compliance_m - mean_y);
  }
  line.has_slope = most - least >= least_angle_span_deg;
  if (line.has_slope) line.per_deg_m = xy / xx;
  line.at45_m = mean_y - line.per_deg_m * mean_x;
  line.holds = line.at45_m > 0 && (line.has_slope || std::abs(mean_x) <= least_angle_span_deg);
  return line;
}

using SubjectLines = std::map<int, SubjectLine>;

/// Each trial's own A, and its subject's line through them.
SubjectLines settle_lines(std::vector<PushedTrial>& trials, const SpringShape& shape) {
  SubjectLines lines;
  for (PushedTrial& trial : trials) {
    trial.compliance_m = spring_compliance_m(*trial.sums, shape);
    lines[trial.subject];
  }
  for (auto& [subject, line] : lines) line = line_of(trials, subject);
  for (PushedTrial& trial : trials) {
    const SubjectLine& line = lines[trial.subject];
    trial.on_line_m = line.at45_m + line.per_deg_m * trial.from45_deg;
  }
  return lines;
}

/// The sums of all trials as those of one whose A is 1, each subject with the same weight.
struct PooledSums {
  SpringSums whole = SpringSums::Zero();
  double turns = 0;  ///< variance of v/|v| along the axis about each stretch's mean, 1 at the most
  /// What each term has that its own trial's spring_ratio has not. Each trial has an A of its own; did one
  /// for all explain their positions, those that stick further, of more friction, would seem stiffer far out,
  /// and all springs bent.
  SpringSums beside_ratio = SpringSums::Zero();
};

PooledSums pooled_sums(const std::vector<PushedTrial>& trials) {
  PooledSums pooled;
  for (const PushedTrial& trial : trials) {
    if (!(trial.on_line_m > 0)) continue;
    SpringTerms scale;
    scale << 1 / trial.on_line_m, 1, 1, 1 / trial.on_line_m, 1 / trial.on_line_m, 1;
    const SpringSums scaled = scale.asDiagonal() * *trial.sums * scale.asDiagonal();
    const double ratio2 = scaled(spring_ratio, spring_ratio);
    pooled.turns += trial.weight * (*trial.sums)(spring_direction, spring_direction) / trial.samples;
    pooled.whole += trial.weight / ratio2 * scaled;
    pooled.beside_ratio +=
        trial.weight / ratio2 * (scaled - scaled.col(spring_ratio) * scaled.row(spring_ratio) / ratio2);
  }
  return pooled;
}

/// Regression of the position on the terms beside the ratio; those that say nothing beside the ones before
/// them are 0. So is the loop's where no stretch of stick turns round: rounding alone moves v/|v| then.
SpringTerms regression(const PooledSums& pooled) {
  constexpr double least_own = 1e-3;  // of a term's spread, that the terms before it do not have
  constexpr double least_turns = 1e-4;
  const SpringSums& m = pooled.beside_ratio;
  std::vector<Eigen::Index> used;
  Eigen::VectorXd solved;
  for (const Eigen::Index term : {spring_speed, spring_direction, spring_cubic}) {
    if (term == spring_direction && !(pooled.turns > least_turns)) continue;
    std::vector<Eigen::Index> tried = used;
    tried.push_back(term);
    const auto n = static_cast<Eigen::Index>(tried.size());
    Eigen::MatrixXd a(n, n);
    Eigen::VectorXd b(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      b[i] = m(tried[static_cast<std::size_t>(i)], spring_position);
      for (Eigen::Index j = 0; j < n; ++j)
        a(i, j) = m(tried[static_cast<std::size_t>(i)], tried[static_cast<std::size_t>(j)]);
    }
    const double own = 1 / a.inverse()(n - 1, n - 1), whole = pooled.whole(term, term);
    if (!(own > least_own * whole) || !(whole > 0)) continue;
    used = tried;
    solved = a.ldlt().solve(b);
  }
  SpringTerms found = SpringTerms::Zero();
  for (std::size_t i = 0; i < used.size(); ++i) found[used[i]] = solved[static_cast<Eigen::Index>(i)];
  return found;
}

void add_slope(const std::vector<PushedTrial>& trials, const SubjectLines& lines, SpringFit& fit) {
  double xx = 0, xy = 0;
  for (const PushedTrial& p : trials) {
    const SubjectLine& line = lines.at(p.subject);
    if (!line.has_slope || !line.holds) continue;
    xx += p.weight * p.from45_deg * p.from45_deg;
    xy += p.weight * p.from45_deg * (1 - p.compliance_m / line.at45_m);
  }
  if (xx > 0) fit.slope_per_deg = xy / xx;
  if (!(xx > 0)) fit.slope_refusal = "one finger angle only; it takes some that differ by 10 degrees";
}

/// The share of the displacement's variance that each trial's own straight line explains, the delay being
/// taken out.
double linearity(const std::vector<PushedTrial>& trials, double delay_s) {
  double all = 0, explained = 0;
  for (const PushedTrial& trial : trials) {
    const SpringSums& m = *trial.sums;
    const double xr = m(spring_position, spring_straight) - delay_s * m(spring_speed, spring_straight),
                 xx = m(spring_position, spring_position) - 2 * delay_s * m(spring_position, spring_speed) +
                      delay_s * delay_s * m(spring_speed, spring_speed),
                 rr = m(spring_straight, spring_straight);
    const double weight = trial.weight / rr / (trial.compliance_m * trial.compliance_m);
    all += weight * xx;
    explained += weight * xr * xr / rr;
  }
  return explained / all;
}

/// Mean over the subjects whose line holds; 0 where none does.
double mean_at45_m(const SubjectLines& lines) {
  double sum = 0, count = 0;
  for (const auto& [subject, line] : lines) {
    if (!line.holds) continue;
    sum += line.at45_m;
    ++count;
  }
  return count > 0 ? sum / count : 0;
}

void refuse_all(SpringFit& fit, const std::string& axis, const std::string& angle) {
  fit.axis_refusal = fit.shape_refusal = fit.hysteresis_refusal = axis;
  fit.slope_refusal = angle;
}

}  // namespace

bool pushes_along(const TrialEvidence& trial, std::size_t axis) {
  constexpr double least_share = 0.01;  // a trial pushed along the other axis has only noise along this one
  const SpringSums &own = trial.spring[axis], &other = trial.spring[1 - axis];
  const double both2 = own(spring_ratio, spring_ratio) + other(spring_ratio, spring_ratio);
  return trial.has_direction && own(spring_ratio, spring_ratio) > least_share * both2 &&
         own(spring_position, spring_ratio) > 0;
}

double spring_compliance_m(const SpringSums& m, const SpringShape& shape) {
  const double b = shape.share_left, h = shape.hysteresis_m, d = shape.delay_s;
  const auto with_spring = [&](SpringTerm term) { return m(term, spring_ratio) + b * m(term, spring_cubic); };
  const double pull =
      with_spring(spring_position) - h * with_spring(spring_direction) - d * with_spring(spring_speed);
  const double spread = m(spring_ratio, spring_ratio) + 2 * b * m(spring_ratio, spring_cubic) +
                        b * b * m(spring_cubic, spring_cubic);
  return pull / spread;
}

SpringFit fit_spring(const std::vector<TrialEvidence>& trials, const std::vector<int>& times, int axis) {
  SpringFit fit;
  std::vector<PushedTrial> pushed = pushed_trials(trials, times, axis, fit);
  if (pushed.empty()) {
    const bool has_direction =
        std::any_of(trials.begin(), trials.end(), [](const TrialEvidence& t) { return t.has_direction; });
    if (has_direction)
      refuse_all(fit, "no stick was pushed along this axis", "no stick was pushed along this axis");
    if (!has_direction)
      refuse_all(fit, "columns dx, dy, dz missing: the finger's axes are not known",
                 "columns dx, dy, dz missing: the finger's angle is not known");
    return fit;
  }
  SpringShape shape;
  SubjectLines lines = settle_lines(pushed, shape);
  fit.straight45_m = mean_at45_m(lines);
  if (!(fit.straight45_m > 0)) fit.axis_refusal = "one finger angle only, more than 10 degrees from 45";
  PooledSums pooled = pooled_sums(pushed);
  constexpr int passes = 3;
  for (int pass = 0; pass < passes; ++pass) {
    const auto found = regression(pooled);
    fit.hysteresis_refusal = found[spring_direction] == 0 ? "stick is not pushed to and fro" : "";
    shape = {found[spring_cubic], found[spring_direction], found[spring_speed]};
    lines = settle_lines(pushed, shape);
    pooled = pooled_sums(pushed);
  }
  fit.compliance45_m = mean_at45_m(lines);
  fit.shape = shape;
  fit.linearity = linearity(pushed, shape.delay_s);
  add_slope(pushed, lines, fit);
  return fit;
}

}  // namespace fingerpad
