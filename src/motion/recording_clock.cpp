#include "motion/recording_clock.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/number_text.hpp"

namespace fingerpad {
namespace {

/// The rate in as few digits as keep the last sample within `sure_s` of its place.
double rounded_rate_hz(double step_s, double steps, double sure_s) {
  const double rate_hz = 1 / step_s;
  for (int digits = 3; digits < 15; ++digits) {
    const double rounded_hz = *parse_number(fmt::format("{:.{}g}", rate_hz, digits));
    if (steps * std::abs(1 / rounded_hz - step_s) <= sure_s) return rounded_hz;
  }
  return rate_hz;
}

bool is_even(std::span<const double> t_s, double rate_hz) {
  for (std::size_t i = 0; i < t_s.size(); ++i) {
    if (std::abs((t_s[i] - t_s[0]) * rate_hz - static_cast<double>(i)) > 1e-6) return false;
  }
  return true;
}

}  // namespace

RecordingClock recording_clock(std::span<const double> t_s) {
  RecordingClock clock;
  if (t_s.size() < 2) return clock;
  std::vector<double> steps_s;
  for (std::size_t i = 1; i < t_s.size(); ++i) steps_s.push_back(t_s[i] - t_s[i - 1]);
  const auto longest = std::max_element(steps_s.begin(), steps_s.end());
  clock.longest_s = *longest;
  clock.longest_at_s = t_s[static_cast<std::size_t>(longest - steps_s.begin())];
  clock.shortest_s = *std::min_element(steps_s.begin(), steps_s.end());
  clock.steps = static_cast<long>(steps_s.size());

  // The lower median, so that of two steps a gap is not taken for the clock.
  const auto middle = steps_s.begin() + static_cast<std::ptrdiff_t>((steps_s.size() - 1) / 2);
  std::nth_element(steps_s.begin(), middle, steps_s.end());
  const double median_s = *middle;
  const auto is_odd = [](double step_s, double like_s) { return std::abs(step_s - like_s) > 0.5 * like_s; };
  // From the ends: rounding in a sum of 300,000 steps is enough to miss a rate of 2000 Hz.
  double sum_s = t_s.back() - t_s.front(), count = static_cast<double>(steps_s.size());
  for (const double step_s : steps_s) {
    if (!is_odd(step_s, median_s)) continue;
    sum_s -= step_s;
    --count;
  }
  const double step_s = sum_s / count;
  double jitter_s = 0;
  for (const double each_s : steps_s) {
    clock.odd_steps += is_odd(each_s, step_s) ? 1 : 0;
    if (!is_odd(each_s, median_s)) jitter_s = std::max(jitter_s, std::abs(each_s - step_s));
  }
  // Both ends' times are rounded, each by as much as two neighbours' differ in their step.
  clock.rate_hz = rounded_rate_hz(step_s, count, 2 * jitter_s + 1e-7 * step_s);
  clock.is_even = is_even(t_s, clock.rate_hz);
  return clock;
}

std::string clock_text(const RecordingClock& clock) {
  const std::string steps =
      clock.is_even
          ? fmt::format("{} even step{}", clock.steps, clock.steps == 1 ? "" : "s")
          : fmt::format("median of {} steps, from {} to {} ms", clock.steps,
                        rounded_text(1e3 * clock.shortest_s, 3), rounded_text(1e3 * clock.longest_s, 3));
  return fmt::format("{} Hz ({})", rounded_text(clock.rate_hz, 6), steps);
}

}  // namespace fingerpad
