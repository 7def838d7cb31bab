#include "study/force_tare.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "study/air_evidence.hpp"
#include "study/press_corner.hpp"
#include "study/sample_noise.hpp"
#include "study/tare_line.hpp"

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

using Samples = std::vector<Eigen::Index>;

constexpr std::size_t fewest_free = 20;

Eigen::Index window_of(const RecordedTrial& trial) {
  return std::max<Eigen::Index>(4, std::lround(window_s * trial.rate_hz));
}

/// The samples of all windows that are still and low.
Samples free_samples(const RecordedTrial& trial, const PressLevels& levels) {
  const Eigen::Index window = window_of(trial);
  Samples found;
  for (Eigen::Index from = 0; from + window <= trial.samples(); from += window / 2) {
    if (!is_still(trial, levels, from, from + window)) continue;
    for (Eigen::Index i = found.empty() ? from : std::max(from, found.back() + 1); i < from + window; ++i)
      found.push_back(i);
  }
  if (found.size() < fewest_free) found.clear();
  return found;
}

/// Runs of two such windows or more, half a window apart, whose means differ by less than the noise.
std::vector<StillRun> level_runs(const RecordedTrial& trial, const PressLevels& levels, double noise_n) {
  const Eigen::Index window = window_of(trial), step = window / 2;
  std::vector<StillRun> runs;
  for (Eigen::Index from = 0; from + window <= trial.samples(); from += step) {
    if (!is_still(trial, levels, from, from + window)) continue;
    double normal_n = 0;
    for (Eigen::Index i = from; i < from + window; ++i)
      normal_n += levels.normal_n[static_cast<std::size_t>(i)] / static_cast<double>(window);
    const bool goes_on = !runs.empty() && runs.back().to == from - step + window &&
                         std::abs(normal_n - runs.back().normal_n) < noise_n;
    if (goes_on) runs.back().to = from + window;
    if (!goes_on) runs.push_back({from, from + window, normal_n});
  }
  std::erase_if(runs, [window](const StillRun& run) { return run.to - run.from == window; });
  return runs;
}

/// Whether the finger leaves the run's level as one that comes down on the plate or is lifted from it does:
/// in a corner. It must come 20 deviations of the noise above it about as fast as the run is long (twice,
/// where the trial begins or ends with the run), without a sample missing.
bool is_left_in_a_corner(const RecordedTrial& trial, const PressLevels& levels, const StillRun& run,
                         double noise_n) {
  constexpr double surely_above = 20, most_length = 0.8;
  const Eigen::Index window = window_of(trial);
  const double above_n = run.normal_n + surely_above * noise_n;
  const bool is_half = run.from < window || trial.samples() - run.to < window;
  const auto most =
      static_cast<Eigen::Index>((is_half ? 2 : 1) * most_length * static_cast<double>(run.to - run.from));
  Eigen::Index first = run.from, last = run.to - 1;
  bool is_left = false;
  for (const Eigen::Index way : {Eigen::Index{-1}, Eigen::Index{1}}) {
    const Eigen::Index edge = way < 0 ? run.from - 1 : run.to;
    for (Eigen::Index i = edge; i >= 0 && i < trial.samples(); i += way) {
      const auto k = static_cast<std::size_t>(i);
      if (std::abs(i - edge) > most || trial.origin[k] == SampleOrigin::missing) return false;
      (way < 0 ? first : last) = i;
      if (levels.normal_n[k] < above_n) continue;
      is_left = true;
      break;
    }
  }
  const auto count = static_cast<std::size_t>(last - first + 1);
  return is_left &&
         leaves_in_corners(std::span(levels.normal_n).subspan(static_cast<std::size_t>(first), count),
                           static_cast<std::size_t>(run.from - first),
                           static_cast<std::size_t>(run.to - first), static_cast<std::size_t>(window / 2));
}

/// The samples of short moments without contact beside slow ramps: those of runs that are left in a corner,
/// if all such are about as low.
Samples cornered_samples(const RecordedTrial& trial, const PressLevels& levels, double noise_n) {
  constexpr double least_press = 40, alike = 0.1;  // of the noise; of the press
  Samples found;
  if (!(levels.press_n - levels.low_n > least_press * noise_n)) return found;
  double least_n = 0, most_n = 0;
  for (const StillRun& run : level_runs(trial, levels, noise_n)) {
    if (!is_left_in_a_corner(trial, levels, run, noise_n)) continue;
    least_n = found.empty() ? run.normal_n : std::min(least_n, run.normal_n);
    most_n = found.empty() ? run.normal_n : std::max(most_n, run.normal_n);
    for (Eigen::Index i = run.from; i < run.to; ++i) found.push_back(i);
  }
  // Runs may share half a window.
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  const bool are_alike = most_n - least_n < alike * (levels.press_n - levels.low_n);
  if (found.size() < fewest_free || !are_alike) found.clear();
  return found;
}

/// The runs that samples make, one after the other.
std::vector<StillRun> runs_of(const PressLevels& levels, const Samples& samples) {
  std::vector<StillRun> runs;
  for (const Eigen::Index i : samples) {
    if (runs.empty() || runs.back().to != i) runs.push_back({i, i, 0});
    ++runs.back().to;
  }
  for (StillRun& run : runs) {
    for (Eigen::Index i = run.from; i < run.to; ++i)
      run.normal_n += levels.normal_n[static_cast<std::size_t>(i)] / static_cast<double>(run.to - run.from);
  }
  return runs;
}

Samples samples_of(const std::vector<StillRun>& runs) {
  Samples samples;
  for (const StillRun& run : runs) {
    for (Eigen::Index i = run.from; i < run.to; ++i) samples.push_back(i);
  }
  if (samples.size() < fewest_free) samples.clear();
  return samples;
}

/// A finger that presses less now and then passes slowly through the forces in between; one that is lifted
/// is gone. What counts as free is not in between, though the sensor drifts.
bool passes_slowly(const RecordedTrial& trial, const PressLevels& levels, const Samples& free,
                   double noise_n) {
  constexpr double most_between = 0.3, half_way = 0.5, beyond_noise = 4;
  const Tare tare(trial.force_W, free);
  long between = 0;
  auto next = free.begin();
  for (Eigen::Index i = 0; i < trial.samples(); ++i) {
    if (next != free.end() && *next == i) {
      ++next;
      continue;
    }
    const double above_n = levels.normal_n[static_cast<std::size_t>(i)] - trial.normal_W.dot(tare.at(i));
    if (above_n > beyond_noise * noise_n && above_n < half_way * (levels.press_n - levels.low_n)) ++between;
  }
  return static_cast<double>(between) > most_between * static_cast<double>(free.size());
}

}  // namespace

FreeMoments moments_without_contact(const RecordedTrial& trial) {
  const PressLevels levels(trial);
  const double noise_n = std::abs(trial.normal_W.cwiseAbs().dot(levels.noise_n)),
               press_n = levels.press_n - levels.low_n;
  if (!(press_n > 20 * noise_n)) return {};
  Samples free = free_samples(trial, levels);
  if (free.empty()) return {};
  AirRuns air = runs_in_the_air(trial, runs_of(levels, free), noise_n, press_n);
  if (passes_slowly(trial, levels, free, noise_n)) {
    // A corner shows where a slow ramp begins; without one only what height tells is sure.
    const AirRuns cornered =
        runs_in_the_air(trial, runs_of(levels, cornered_samples(trial, levels, noise_n)), noise_n, press_n);
    if (!cornered.surely.empty() || !cornered.perhaps.empty())
      air = cornered;
    else
      air.perhaps.clear();
  }
  if (!trial.lacks.empty()) air.perhaps.clear();  // no friction would tell that the finger rubs on
  std::vector<StillRun> runs = std::move(air.surely);
  runs.insert(runs.end(), air.perhaps.begin(), air.perhaps.end());
  std::sort(runs.begin(), runs.end(), [](const StillRun& a, const StillRun& b) { return a.from < b.from; });
  return {samples_of(runs), air.presses_on && runs.empty(), air.falls_at_once && runs.empty()};
}

void take_tare(RecordedTrial& trial, TrialCleaning& cleaning) {
  const FreeMoments moments = moments_without_contact(trial);
  const Samples& free = moments.samples;
  cleaning.presses_on = moments.presses_on;
  cleaning.falls_at_once = moments.falls_at_once;
  if (free.empty()) return;
  const Tare tare(trial.force_W, free);
  for (Eigen::Index i = 0; i < trial.samples(); ++i) trial.force_W.col(i) -= tare.at(i);
  if (trial.sensor) {
    const Tare torque(trial.torque_W_n_m, free);
    for (Eigen::Index i = 0; i < trial.samples(); ++i) trial.torque_W_n_m.col(i) -= torque.at(i);
  }
  cleaning.free_samples = static_cast<long>(free.size());
  cleaning.tare_begin_n = tare.begin_n;
  cleaning.tare_end_n = tare.end_n;
}

}  // namespace fingerpad
