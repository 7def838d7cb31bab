#include "study/force_tare.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "study/sample_noise.hpp"

namespace fingerpad {
namespace {

constexpr double window_s = 0.05;

/// How hard the plate is pressed in a trial, and how noisy each axis of its force is.
struct PressLevels {
  std::vector<double> normal_n;
  Vec3 noise_n;
  double low_n, press_n;

  explicit PressLevels(const RecordedTrial& trial) {
    const Eigen::Index n = trial.samples();
    std::vector<double> axis_n(static_cast<std::size_t>(n));
    for (Eigen::Index i = 0; i < n; ++i) normal_n.push_back(trial.normal_W.dot(trial.force_W.col(i)));
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      for (Eigen::Index i = 0; i < n; ++i) axis_n[static_cast<std::size_t>(i)] = trial.force_W(axis, i);
      noise_n[axis] = sample_noise(axis_n);
    }
    low_n = quantile(normal_n, 0.01);
    press_n = quantile(normal_n, 0.9);
  }
  /// Below it nothing may press.
  double near_n() const noexcept { return low_n + 0.25 * (press_n - low_n); }
};

/// Whether a window's forces are as still as their noise, and low.
bool is_still(const RecordedTrial& trial, const PressLevels& levels, Eigen::Index from, Eigen::Index to) {
  constexpr double stillness = 2.5;
  Vec3 mean = Vec3::Zero(), squares = Vec3::Zero();
  const auto count = static_cast<double>(to - from);
  for (Eigen::Index i = from; i < to; ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (trial.origin[k] == SampleOrigin::missing || levels.normal_n[k] > levels.near_n()) return false;
    mean += trial.force_W.col(i) / count;
  }
  for (Eigen::Index i = from; i < to; ++i) squares += (trial.force_W.col(i) - mean).cwiseAbs2() / count;
  return (squares.cwiseSqrt().array() <= stillness * levels.noise_n.array() + 1e-9 * levels.press_n).all();
}

/// The samples of all windows that are still and low.
std::vector<Eigen::Index> free_samples(const RecordedTrial& trial, const PressLevels& levels) {
  const auto window = std::max<Eigen::Index>(4, std::lround(window_s * trial.rate_hz));
  std::vector<Eigen::Index> found;
  for (Eigen::Index from = 0; from + window <= trial.samples(); from += window / 2) {
    if (!is_still(trial, levels, from, from + window)) continue;
    for (Eigen::Index i = found.empty() ? from : std::max(from, found.back() + 1); i < from + window; ++i)
      found.push_back(i);
  }
  if (found.size() < 20) found.clear();
  return found;
}

/// A line through an axis' samples.
struct TareLine {
  double middle = 0, level_n = 0, slope_n = 0;
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
  double squares = 0, drift = 0;
  for (const Eigen::Index i : samples) {
    const double off = static_cast<double>(i) - line.middle;
    squares += off * off;
    drift += off * (trial.force_W(axis, i) - line.level_n);
  }
  if (takes_slope && squares > 0) line.slope_n = drift / squares;
  return line;
}

}  // namespace

void take_tare(RecordedTrial& trial, TrialCleaning& cleaning) {
  const Eigen::Index n = trial.samples();
  const PressLevels levels(trial);
  const double noise_n = std::abs(trial.normal_W.cwiseAbs().dot(levels.noise_n));
  if (!(levels.press_n - levels.low_n > 20 * noise_n)) return;
  const std::vector<Eigen::Index> free = free_samples(trial, levels);
  if (free.empty()) return;
  const bool takes_slope = 3 * (free.back() - free.front()) > n;
  Vec3 begin_n, end_n;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const TareLine line = line_through(trial, axis, free, takes_slope);
    begin_n[axis] = line.at(0);
    end_n[axis] = line.at(static_cast<double>(n - 1));
  }
  const double last = static_cast<double>(std::max<Eigen::Index>(n - 1, 1));
  const auto tare_at = [&](Eigen::Index i) -> Vec3 {
    return begin_n + (static_cast<double>(i) / last) * (end_n - begin_n);
  };
  // A finger that presses less now and then passes slowly through the forces in between; one that is lifted
  // is gone.
  constexpr double most_between = 0.3, half_way = 0.5, beyond_noise = 4;
  long between = 0;
  for (Eigen::Index i = 0; i < n; ++i) {
    const double above_n = levels.normal_n[static_cast<std::size_t>(i)] - trial.normal_W.dot(tare_at(i));
    if (above_n > beyond_noise * noise_n && above_n < half_way * (levels.press_n - levels.low_n)) ++between;
  }
  if (static_cast<double>(between) > most_between * static_cast<double>(free.size())) return;
  for (Eigen::Index i = 0; i < n; ++i) trial.force_W.col(i) -= tare_at(i);
  cleaning.free_samples = static_cast<long>(free.size());
  cleaning.tare_begin_n = begin_n;
  cleaning.tare_end_n = end_n;
}

}  // namespace fingerpad
