#include "study/measurement_doubts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "base/error.hpp"
#include "motion/driving_share.hpp"
#include "motion/pressed_force.hpp"

namespace fingerpad {
namespace {

/// The trials of one file.
using FileTrials = std::span<const RecordedTrial>;

double pressing_n(const RecordedTrial& trial) {
  const Eigen::RowVectorXd along_n = trial.normal_W.transpose() * trial.force_W;
  return pressed_median_n({along_n.data(), static_cast<std::size_t>(along_n.size())});
}

double extent_m(const RecordedTrial& trial) {
  return (trial.position_W.rowwise().maxCoeff() - trial.position_W.rowwise().minCoeff()).maxCoeff();
}

/// The median over a file's trials that have it; not a number where none has.
double usual(FileTrials trials, const std::function<double(const RecordedTrial&)>& of) {
  std::vector<double> values;
  for (const RecordedTrial& trial : trials) {
    if (const double value = of(trial); !std::isnan(value)) values.push_back(value);
  }
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::sort(values.begin(), values.end());
  return (values[(values.size() - 1) / 2] + values[values.size() / 2]) / 2;
}

void ask_for_units(FileTrials trials, const MeasurementFormat& format) {
  constexpr double hardest_n = 40, lightest_n = 0.01, farthest_way_m = 1, slowest_hz = 20, fastest_hz = 200e3;
  const std::string& file = trials.front().file;
  const double rate_hz = usual(trials, [](const RecordedTrial& trial) { return trial.rate_hz; });
  if (!format.says_time_unit && (rate_hz < slowest_hz || rate_hz > fastest_hz))
    throw refused(
        file, fmt::format("taken as seconds, its times give {:.3g} samples a second: say --time-unit ms (or "
                          "us), or --time-unit s if they are seconds",
                          rate_hz));
  const double way_m = usual(trials, extent_m);
  if (!format.says_unit && way_m > farthest_way_m)
    throw refused(
        file, fmt::format("taken as metres, its positions reach over {:.3g} m: say --unit mm (or cm, in), "
                          "or --unit m if they are metres",
                          way_m));
  const double press_n = std::abs(usual(trials, pressing_n));
  if (!format.says_force_unit && press_n > hardest_n)
    throw refused(
        file, fmt::format("taken as newtons, its normal force is {:.3g} N, harder than a finger rubs: say "
                          "--force-unit mN (or gf), or --force-unit N if they are newtons",
                          press_n));
  if (!format.says_force_unit && press_n > 0 && press_n < lightest_n)
    throw refused(
        file, fmt::format("taken as newtons, its normal force is {:.3g} N, lighter than a finger rubs: say "
                          "--force-unit kN, or --force-unit N if they are newtons",
                          press_n));
}

/// A trial's positions and forces of the same moments, where force lags position by a delay.
struct SameMoments {
  Eigen::Ref<const Points> position_W, force_W;
};

SameMoments same_moments(const RecordedTrial& trial, double delay_s) {
  const Eigen::Index n = trial.samples(), most = n / 2,
                     lag = std::clamp<Eigen::Index>(std::lround(delay_s * trial.rate_hz), -most, most),
                     count = n - std::abs(lag);
  return {trial.position_W.middleCols(std::max<Eigen::Index>(-lag, 0), count),
          trial.force_W.middleCols(std::max<Eigen::Index>(lag, 0), count)};
}

/// No turn of a sensor puts right what one axis has of a mirror.
void refuse_mirrored_axis(FileTrials trials, double delay_s) {
  Vec3 share;
  for (int axis = 0; axis < 3; ++axis) {
    share[axis] = usual(trials, [&](const RecordedTrial& trial) {
      const SameMoments both = same_moments(trial, delay_s);
      return driving_share_by_axis(both.position_W, both.force_W, trial.rate_hz)[axis];
    });
  }
  for (int axis = 0; axis < 3; ++axis) {
    const bool others_brake = (share.array() < -most_driving_share).any();
    if (!(share[axis] > most_driving_share) || !others_brake) continue;
    throw refused(
        trials.front().file,
        fmt::format("along {0} alone its force drives the finger, and friction holds a finger back: "
                    "the force or the position along {0} is mirrored; turn that column's sign",
                    "xyz"[axis]));
  }
}

void ask_for_signs(FileTrials trials, const MeasurementFormat& format, double delay_s) {
  constexpr double surely_n = 0.15;  // a sensor's offset may be below 0 where nothing presses
  const std::string& file = trials.front().file;
  const double press_n = usual(trials, pressing_n);
  if (press_n < -surely_n)
    throw refused(
        file, fmt::format(
                  "its force is {:.3g} N along the plate's normal where it presses, and a plate pushes a "
                  "finger away: say {} if it is the force on the {}, or give the normal (nx, ny, nz) or how "
                  "the sensor stands (--sensor-turned)",
                  press_n, format.force_on_plate ? "--force-on finger" : "--force-on plate",
                  format.force_on_plate ? "finger" : "plate"));
  refuse_mirrored_axis(trials, delay_s);
  const double drives = usual(trials, [delay_s](const RecordedTrial& trial) {
    const SameMoments both = same_moments(trial, delay_s);
    return driving_share(both.position_W, both.force_W, trial.rate_hz);
  });
  if (drives > most_driving_share)
    throw refused(
        file,
        "its force drives the finger along its way, and friction holds a finger back: fx and fy have the "
        "wrong sign while the normal force has the right one. --force-on turns all three, --sensor-turned "
        "0,0,0,1 (half a turn about z) fx and fy alone. A force that comes over 50 ms after the position "
        "looks like it too: then say --delay SECONDS");
}

}  // namespace

void refuse_doubtful(const RecordedMeasurement& recorded, const MeasurementFormat& format, double delay_s) {
  const std::vector<RecordedTrial>& trials = recorded.trials;
  for (std::size_t from = 0, to = 0; from < trials.size(); from = to) {
    while (to < trials.size() && trials[to].file == trials[from].file) ++to;
    const FileTrials own(trials.data() + from, to - from);
    ask_for_units(own, format);
    ask_for_signs(own, format, delay_s);
  }
}

}  // namespace fingerpad
