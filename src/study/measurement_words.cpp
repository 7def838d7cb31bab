#include "study/measurement_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <set>

#include "base/number_text.hpp"
#include "study/file_trials.hpp"
#include "study/six_axis_sensor.hpp"

namespace fingerpad {
namespace {

/// "2.1", or "1.9 to 2.1" where they differ.
std::string range_text(double least, double most) {
  const std::string low = rounded_text(least, 4), high = rounded_text(most, 4);
  return low == high ? low : fmt::format("{} to {}", low, high);
}

}  // namespace

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
