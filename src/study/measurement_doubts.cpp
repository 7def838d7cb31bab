#include "study/measurement_doubts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <set>
#include <span>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "base/number_text.hpp"
#include "motion/driving_share.hpp"
#include "motion/pressed_force.hpp"
#include "study/six_axis_sensor.hpp"

namespace fingerpad {
namespace {

/// The trials of one file.
using FileTrials = std::span<const RecordedTrial>;

double pressing_n(const RecordedTrial& trial) {
  const Eigen::RowVectorXd along_n = trial.normal_W.transpose() * trial.force_W;
  return pressed_median_n({along_n.data(), static_cast<std::size_t>(along_n.size())});
}

double extent_m(const RecordedTrial& trial) {
  const Points& places_W = finger_W(trial);
  return (places_W.rowwise().maxCoeff() - places_W.rowwise().minCoeff()).maxCoeff();
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

/// Faster than all but a twentieth of a trial's ways over 12 ms, or over all of a shorter one.
double fastest_m_per_s(const RecordedTrial& trial) {
  constexpr double window_s = 12e-3, most_share = 0.95;
  const auto window = static_cast<Eigen::Index>(std::lround(window_s * trial.rate_hz));
  const auto step = std::max<Eigen::Index>(1, std::min<Eigen::Index>(window, trial.samples() - 1));
  const Points& places_W = finger_W(trial);
  std::vector<double> speeds;
  for (Eigen::Index i = 0; i + step < trial.samples(); i += step)
    speeds.push_back((places_W.col(i + step) - places_W.col(i)).norm() * trial.rate_hz /
                     static_cast<double>(step));
  if (speeds.empty()) return 0;
  std::sort(speeds.begin(), speeds.end());
  return speeds[static_cast<std::size_t>(most_share * static_cast<double>(speeds.size() - 1))];
}

double largest_force_n(const RecordedTrial& trial) {
  return trial.force_W.colwise().norm().maxCoeff();
}

/// What is not a finger's of a file's trials.
struct UnitDoubt {
  bool is_refused = false;  ///< and its unit was not said
  std::string words;
};

constexpr std::string_view units_checked =
    "are the units right (the options that say them, and the table's)?";

void doubt_times(FileTrials trials, const MeasurementFormat& format, std::vector<UnitDoubt>& doubts) {
  constexpr double slowest_hz = 20, fastest_hz = 100e3, refused_hz = 200e3;
  const double rate_hz = usual(trials, [](const RecordedTrial& trial) { return trial.rate_hz; });
  if (rate_hz >= slowest_hz && rate_hz <= fastest_hz) return;
  if (!format.says_time_unit && !(rate_hz >= slowest_hz && rate_hz <= refused_hz)) {
    doubts.push_back(
        {true, fmt::format("taken as seconds, its times give {} samples a second: say --time-unit ms (or "
                           "us), or --time-unit s if they are seconds",
                           rounded_text(rate_hz, 3))});
    return;
  }
  doubts.push_back({false, fmt::format("its times give {} samples a second, at which no finger is "
                                       "measured: {}",
                                       rounded_text(rate_hz, 3), units_checked)});
}

void doubt_positions(FileTrials trials, const MeasurementFormat& format, std::vector<UnitDoubt>& doubts) {
  constexpr double farthest_m = 0.5, refused_m = 1, fastest = 1.5;
  const double nearest_m = trials.front().lacks.empty() ? 0.5e-3 : 0.05e-3;  // what a pad yields
  const double way_m = usual(trials, extent_m), speed = usual(trials, fastest_m_per_s);
  if (!format.says_unit && way_m > refused_m) {
    doubts.push_back(
        {true, fmt::format("taken as metres, its positions reach over {} m: say --unit mm (or cm, in), "
                           "or --unit m if they are metres",
                           rounded_text(way_m, 3))});
    return;
  }
  if (way_m < nearest_m || way_m > farthest_m)
    doubts.push_back({false, fmt::format("its positions reach over {} mm, {} than a finger rubs: {}",
                                         rounded_text(1e3 * way_m, 3), way_m < nearest_m ? "less" : "farther",
                                         units_checked)});
  if (speed > fastest)
    doubts.push_back({false, fmt::format("its positions go at {} m/s, faster than a finger rubs: {}",
                                         rounded_text(speed, 3), units_checked)});
}

void doubt_forces(FileTrials trials, const MeasurementFormat& format, std::vector<UnitDoubt>& doubts) {
  constexpr double hardest_n = hardest_rub_n, lightest_n = lightest_rub_n, greatest_n = 100;
  const double press_n = std::abs(usual(trials, pressing_n)), most_n = usual(trials, largest_force_n);
  if (!format.says_force_unit && press_n > hardest_n) {
    doubts.push_back(
        {true, fmt::format("taken as newtons, its normal force is {} N, harder than a finger rubs: say "
                           "--force-unit mN (or gf), or --force-unit N if they are newtons",
                           rounded_text(press_n, 3))});
  } else if (!format.says_force_unit && press_n > 0 && press_n < lightest_n) {
    doubts.push_back(
        {true, fmt::format("taken as newtons, its normal force is {} N, lighter than a finger rubs: say "
                           "--force-unit kN, or --force-unit N if they are newtons",
                           rounded_text(press_n, 3))});
  } else if (press_n > hardest_n || (press_n > 0 && press_n < lightest_n)) {
    doubts.push_back(
        {false, fmt::format("its normal force is {} N, {} than a finger rubs: {}", rounded_text(press_n, 3),
                            press_n > hardest_n ? "harder" : "lighter", units_checked)});
  } else if (most_n > greatest_n) {
    doubts.push_back({false, fmt::format("its forces reach {} N, more than a finger's: {}",
                                         rounded_text(most_n, 3), units_checked)});
  }
}

/// How far from a six-axis sensor's origin the forces act that make its torques, at least: of each sample the
/// torque by the force. 0 without torques.
double lever_m(const RecordedTrial& trial) {
  if (trial.torque_W_n_m.cols() == 0) return 0;
  const double force_n = trial.force_W.colwise().norm().mean();
  return force_n > 0 ? trial.torque_W_n_m.colwise().norm().mean() / force_n : 0;
}

void doubt_torques(FileTrials trials, const MeasurementFormat& format, std::vector<UnitDoubt>& doubts) {
  constexpr double longest_m = 1;
  const double lever = usual(trials, lever_m);
  if (lever <= longest_m) return;
  const std::string of_forces =
      fmt::format("its torques are those of forces {} m from the sensor's origin: ", rounded_text(lever, 3));
  if (format.says_torque_unit) {
    doubts.push_back({false, of_forces + std::string(units_checked)});
  } else {
    doubts.push_back({true, "taken as newton metres, " + of_forces +
                                "say --torque-unit N.mm, or --torque-unit N.m if they are newton metres"});
  }
}

std::vector<UnitDoubt> unit_doubts(FileTrials trials, const MeasurementFormat& format) {
  std::vector<UnitDoubt> doubts;
  doubt_times(trials, format, doubts);
  doubt_torques(trials, format, doubts);  // which places may be told from
  doubt_positions(trials, format, doubts);
  doubt_forces(trials, format, doubts);
  return doubts;
}

/// With the units said that the file's own table tells.
MeasurementFormat with_told(const RecordedMeasurement& recorded, const std::string& file,
                            MeasurementFormat format) {
  const auto found = recorded.told_units.find(file);
  if (found == recorded.told_units.end()) return format;
  const auto tells = [&](Quantity quantity) {
    return found->second[static_cast<std::size_t>(quantity)].has_value();
  };
  format.says_time_unit = format.says_time_unit || tells(Quantity::time);
  format.says_unit = format.says_unit || tells(Quantity::length);
  format.says_force_unit = format.says_force_unit || tells(Quantity::force);
  format.says_torque_unit = format.says_torque_unit || tells(Quantity::torque);
  return format;
}

void ask_for_units(FileTrials trials, const MeasurementFormat& format) {
  for (const UnitDoubt& doubt : unit_doubts(trials, format))
    if (doubt.is_refused) throw refused(trials.front().file, doubt.words);
}

/// Calls `use` with the trials of each file.
template <typename Use>
void each_file(const RecordedMeasurement& recorded, const Use& use) {
  const std::vector<RecordedTrial>& trials = recorded.trials;
  for (std::size_t from = 0, to = 0; from < trials.size(); from = to) {
    while (to < trials.size() && trials[to].file == trials[from].file) ++to;
    use(FileTrials(trials.data() + from, to - from));
  }
}

/// "2.1", or "1.9 to 2.1" where they differ.
std::string range_text(double least, double most) {
  const std::string low = rounded_text(least, 4), high = rounded_text(most, 4);
  return low == high ? low : fmt::format("{} to {}", low, high);
}

/// A trial's positions and forces of the same moments, where force lags position by a delay.
struct SameMoments {
  Eigen::Ref<const Points> position_W, force_W;
};

SameMoments same_moments(const RecordedTrial& trial, double delay_s) {
  const Eigen::Index n = trial.samples(), most = n / 2,
                     lag = std::clamp<Eigen::Index>(std::lround(delay_s * trial.rate_hz), -most, most),
                     count = n - std::abs(lag);
  return {finger_W(trial).middleCols(std::max<Eigen::Index>(-lag, 0), count),
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
                  "its force is {} N along the plate's normal where it presses, and a plate pushes a "
                  "finger away: say {} if it is the force on the {}, or give the normal (nx, ny, nz) or how "
                  "the sensor stands (--sensor-turned)",
                  rounded_text(press_n, 3), format.force_on_plate ? "--force-on finger" : "--force-on plate",
                  format.force_on_plate ? "finger" : "plate"));
  if (!trials.front().lacks.empty()) return;  // no friction, whose sign could be wrong
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
        "looks like it too: then say --delay 7ms");
}

}  // namespace

void refuse_doubtful(const RecordedMeasurement& recorded, const MeasurementFormat& format, double delay_s) {
  each_file(recorded, [&](FileTrials own) {
    ask_for_units(own, with_told(recorded, own.front().file, format));
    ask_for_signs(own, format, delay_s);
  });
}

std::vector<std::string> doubts_of(const RecordedMeasurement& recorded, const MeasurementFormat& format) {
  std::vector<std::string> told;
  each_file(recorded, [&](FileTrials own) {
    for (const UnitDoubt& doubt : unit_doubts(own, with_told(recorded, own.front().file, format)))
      if (!doubt.is_refused) told.push_back(fmt::format("{}: {}", own.front().file, doubt.words));
  });
  return told;
}

std::string measurement_words(const RecordedMeasurement& recorded) {
  if (recorded.trials.empty()) return {};
  constexpr double none = std::numeric_limits<double>::infinity();
  double shortest_s = none, longest_s = 0, slowest_hz = none, fastest_hz = 0, speed = 0, force_n = 0;
  Vec3 reach_m = Vec3::Zero();
  std::set<int> subjects;
  for (const RecordedTrial& trial : recorded.trials) {
    subjects.insert(trial.subject);
    const double span_s = static_cast<double>(trial.samples()) / trial.rate_hz;
    shortest_s = std::min(shortest_s, span_s);
    longest_s = std::max(longest_s, span_s);
    slowest_hz = std::min(slowest_hz, trial.rate_hz);
    fastest_hz = std::max(fastest_hz, trial.rate_hz);
    speed = std::max(speed, fastest_m_per_s(trial));
    force_n = std::max(force_n, largest_force_n(trial));
    const Points& places_W = finger_W(trial);
    reach_m = reach_m.cwiseMax(Vec3(places_W.rowwise().maxCoeff() - places_W.rowwise().minCoeff()));
  }
  const std::size_t trials = recorded.trials.size();
  return fmt::format(
      "understood as {} trial{} of {} subject{}, {} s each at {} samples a second; positions reach over "
      "{} x {} x {} mm, at up to {} m/s; forces up to {} N",
      trials, trials == 1 ? "" : "s", subjects.size(), subjects.size() == 1 ? "" : "s",
      range_text(shortest_s, longest_s), range_text(slowest_hz, fastest_hz),
      rounded_text(1e3 * reach_m.x(), 3), rounded_text(1e3 * reach_m.y(), 3),
      rounded_text(1e3 * reach_m.z(), 3), rounded_text(speed, 3), rounded_text(force_n, 3));
}

}  // namespace fingerpad
