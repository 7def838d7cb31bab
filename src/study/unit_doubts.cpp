#include "study/unit_doubts.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string_view>

#include "base/number_text.hpp"
#include "base/unit.hpp"
#include "motion/force_unit_doubt.hpp"
#include "study/recorders_rate.hpp"

namespace fingerpad {
namespace {

constexpr std::string_view units_checked =
    "are the units right (the options that say them, and the table's)?";

/// The unit in which times make a recorder's rate, at which the finger goes as one does; null where none
/// does.
/// @param rate_hz, speed_m_per_s  as they are read
const TimeUnit* likely_time_unit(double rate_hz, double seconds_per_unit, double speed_m_per_s) {
  constexpr double slowest = 1e-3, fastest = 1.5;
  for (const TimeUnit& unit : time_units) {
    if (unit.seconds > 1) continue;  // nobody forgets to say minutes
    const double times = seconds_per_unit / unit.seconds;
    if (!is_recorders_rate(rate_hz * times)) continue;
    if (speed_m_per_s * times >= slowest && speed_m_per_s * times <= fastest) return &unit;
  }
  return nullptr;
}

/// "if they are in us, which makes 1000 a second, say --time-unit us"; empty where no other unit is likely.
std::string likely_unit_words(FileTrials trials, double rate_hz, double seconds_per_unit, bool tells_times) {
  const TimeUnit* unit = likely_time_unit(rate_hz, seconds_per_unit, usual(trials, fastest_m_per_s));
  if (unit == nullptr) return {};
  return fmt::format("if they are in {0}, which makes {1} a second, {2} {0}", unit->name,
                     rounded_text(rate_hz * seconds_per_unit / unit->seconds, 4),
                     tells_times ? "the unit that its table tells of them is to be" : "say --time-unit");
}

void doubt_times(FileTrials trials, const MeasurementFormat& format, bool tells_times,
                 std::vector<UnitDoubt>& doubts) {
  constexpr double slowest_hz = 20, fastest_hz = 100e3, refused_hz = 200e3;
  const double rate_hz = usual(trials, [](const RecordedTrial& trial) { return trial.rate_hz; });
  if (rate_hz >= slowest_hz && rate_hz <= fastest_hz) return;
  if (!format.says_time_unit && !(rate_hz >= slowest_hz && rate_hz <= refused_hz)) {
    doubts.push_back(
        {true,
         fmt::format("taken as seconds, its times give {} samples a second: say {}, or --time-unit s if they "
                     "are seconds",
                     rounded_text(rate_hz, 3), unit_of_seconds_words(rate_hz)),
         true});
    return;
  }
  const std::string likely = likely_unit_words(trials, rate_hz, format.seconds_per_unit, tells_times);
  doubts.push_back(
      {false,
       fmt::format("its times give {} samples a second, at which no finger is measured: {}",
                   rounded_text(rate_hz, 3), likely.empty() ? std::string(units_checked) : likely),
       true});
}

void doubt_positions(FileTrials trials, const MeasurementFormat& format, std::vector<UnitDoubt>& doubts) {
  constexpr double farthest_m = 0.5, refused_m = 1, fastest = 1.5;
  const double nearest_m = trials.front().lacks.empty() ? 0.5e-3 : 0.05e-3;  // what a pad yields
  const double way_m = usual(trials, extent_m), speed = usual(trials, fastest_m_per_s);
  const double as_metres_m = way_m / format.metres_per_unit;
  if (format.says_unit && way_m < nearest_m && as_metres_m >= nearest_m && as_metres_m <= farthest_m) {
    doubts.push_back({false, fmt::format("in the unit of --unit its positions reach over {} mm, less than a "
                                         "finger rubs, and as metres over {} mm: if they are metres, say "
                                         "--unit m",
                                         rounded_text(1e3 * way_m, 3), rounded_text(1e3 * as_metres_m, 3))});
    return;
  }
  if (!format.says_unit && way_m > refused_m) {
    doubts.push_back(
        {true, fmt::format("taken as metres, its positions reach over {} m: say --unit mm (or cm, in, um), "
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
  constexpr double greatest_n = 100;
  const double press_n = std::abs(usual(trials, pressing_n)), most_n = usual(trials, largest_force_n);
  if (const auto doubt = force_unit_doubt(press_n, format.says_force_unit)) {
    const std::string words = doubt->words(
        "normal force", [](std::string_view unit) { return fmt::format("--force-unit {}", unit); });
    doubts.push_back({doubt->asks_for_unit, words});
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

}  // namespace

std::vector<UnitDoubt> unit_doubts(FileTrials trials, const MeasurementFormat& format, bool tells_times) {
  std::vector<UnitDoubt> doubts;
  doubt_times(trials, format, tells_times, doubts);
  doubt_torques(trials, format, doubts);  // which places may be told from
  doubt_positions(trials, format, doubts);
  doubt_forces(trials, format, doubts);
  return doubts;
}

}  // namespace fingerpad
