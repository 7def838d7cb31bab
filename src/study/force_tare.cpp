#include "study/force_tare.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "study/sample_noise.hpp"

namespace fingerpad {
namespace {

constexpr double least_run_s = 0.05, margin_s = 0.015;

/// Runs of samples whose normal force is below a limit, without the margins in which contact may begin and
/// end.
std::vector<Eigen::Index> low_samples(const RecordedTrial& trial, const std::vector<double>& normal_n,
                                      double limit_n) {
  const auto shortest = static_cast<Eigen::Index>(std::ceil(least_run_s * trial.rate_hz)),
             margin = static_cast<Eigen::Index>(std::ceil(margin_s * trial.rate_hz));
  std::vector<Eigen::Index> found;
  const Eigen::Index n = trial.samples();
  for (Eigen::Index from = 0, to = 0; from < n; from = to + 1) {
    to = from;
    while (to < n && normal_n[static_cast<std::size_t>(to)] < limit_n) ++to;
    if (to - from < std::max<Eigen::Index>(shortest, 4)) continue;
    const Eigen::Index first = from > 0 ? from + margin : 0, last = to < n ? to - margin : n;
    for (Eigen::Index i = first; i < last; ++i)
      if (trial.origin[static_cast<std::size_t>(i)] == SampleOrigin::recorded) found.push_back(i);
  }
  return found;
}

/// A line through an axis' samples.
struct TareLine {
  double middle = 0, level_n = 0, slope_n = 0, rest_n = 0;  ///< rest: standard deviation about it
  double at(double i) const noexcept { return level_n + slope_n * (i - middle); }
};

TareLine line_through(const RecordedTrial& trial, Eigen::Index axis, const std::vector<Eigen::Index>& samples,
                      bool takes_slope) {
  TareLine line;
  const auto count = static_cast<double>(samples.size());
  for (const Eigen::Index i : samples) {
    line.middle += static_cast<double>(i) / count;
    line.level_n += trial.force_W(axis, i) / count;
  }
  double squares = 0, drift = 0, rest = 0;
  for (const Eigen::Index i : samples) {
    const double off = static_cast<double>(i) - line.middle;
    squares += off * off;
    drift += off * (trial.force_W(axis, i) - line.level_n);
  }
  if (takes_slope && squares > 0) line.slope_n = drift / squares;
  for (const Eigen::Index i : samples)
    rest += std::pow(trial.force_W(axis, i) - line.at(static_cast<double>(i)), 2);
  line.rest_n = std::sqrt(rest / count);
  return line;
}

}  // namespace

void take_tare(RecordedTrial& trial, TrialCleaning& cleaning) {
  const Eigen::Index n = trial.samples();
  std::vector<double> normal_n;
  normal_n.reserve(static_cast<std::size_t>(n));
  for (Eigen::Index i = 0; i < n; ++i) normal_n.push_back(trial.normal_W.dot(trial.force_W.col(i)));
  const double noise_n = sample_noise(normal_n), low_n = quantile(normal_n, 0.01),
               press_n = quantile(normal_n, 0.9);
  const double limit_n = low_n + std::max(6 * noise_n, 0.03 * (press_n - low_n)),
               near_n = low_n + 0.25 * (press_n - low_n);
  if (!(press_n - low_n > 20 * noise_n) || !(limit_n < near_n)) return;
  const std::vector<Eigen::Index> free = low_samples(trial, normal_n, limit_n);
  const auto between =
      std::count_if(normal_n.begin(), normal_n.end(), [&](double f) { return f > limit_n && f < near_n; });
  if (free.size() < 20 || static_cast<double>(between) > 0.5 * static_cast<double>(free.size())) return;
  const bool takes_slope = 3 * (free.back() - free.front()) > n;
  Vec3 begin_n, end_n;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    std::vector<double> samples;
    for (Eigen::Index i = 0; i < n; ++i) samples.push_back(trial.force_W(axis, i));
    const TareLine line = line_through(trial, axis, free, takes_slope);
    if (line.rest_n > 2.5 * sample_noise(samples) + 1e-9 * press_n) return;  // something touches it
    begin_n[axis] = line.at(0);
    end_n[axis] = line.at(static_cast<double>(n - 1));
  }
  for (Eigen::Index i = 0; i < n; ++i)
    trial.force_W.col(i) -=
        begin_n +
        (static_cast<double>(i) / static_cast<double>(std::max<Eigen::Index>(n - 1, 1))) * (end_n - begin_n);
  cleaning.free_samples = static_cast<long>(free.size());
  cleaning.tare_begin_n = begin_n;
  cleaning.tare_end_n = end_n;
}

}  // namespace fingerpad
