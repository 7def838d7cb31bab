#include "view/tick_readings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "base/number_text.hpp"

namespace fingerpad {
namespace {

std::string short_time(double seconds) {
  if (seconds >= 1) return fmt::format("{} s", rounded_text(seconds, 2));
  return seconds < 1e-3 ? fmt::format("{} us", rounded_text(1e6 * seconds, 3))
                        : fmt::format("{} ms", rounded_text(1e3 * seconds, 2));
}

}  // namespace

std::vector<Reading> timing_readings(const ServoTiming& timing) {
  return {
      {"median tick", short_time(timing.tick_s(0.5))},
      {"99.9 % of ticks", short_time(timing.tick_s(0.999))},
      {"late ticks", fmt::format("{} ({} %)", timing.late_ticks, rounded_text(100 * timing.late_share(), 2))},
      {"latest", short_time(timing.worst_late_s)}};
}

TickBars tick_bars(const TimeCounts& times) {
  const auto& counts = times.counts;
  const auto some = [](std::uint64_t count) { return count > 0; };
  const auto first = std::find_if(counts.begin(), counts.end(), some);
  const auto last = std::find_if(counts.rbegin(), counts.rend(), some).base();
  if (first >= last) return {};
  const auto scale = [](std::uint64_t count) { return std::log1p(static_cast<double>(count)); };
  const double most = scale(*std::max_element(first, last));
  TickBars bars;
  for (auto at = first; at != last; ++at) bars.heights.push_back(scale(*at) / most);
  const auto upper = [&](auto at) {
    return short_time(TimeCounts::upper_s(static_cast<int>(at - counts.begin())));
  };
  bars.shortest = upper(first);
  bars.longest = upper(last - 1);
  return bars;
}

}  // namespace fingerpad
