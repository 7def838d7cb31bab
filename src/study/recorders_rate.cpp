#include "study/recorders_rate.hpp"

#include <fmt/format.h>

#include "base/unit.hpp"

namespace fingerpad {

bool is_recorders_rate(double rate_hz) {
  constexpr double slowest_hz = 50, fastest_hz = 20e3;
  return rate_hz >= slowest_hz && rate_hz <= fastest_hz;
}

std::string unit_of_seconds_words(double rate_hz) {
  for (const TimeUnit& unit : time_units) {
    if (unit.seconds >= 1 || !is_recorders_rate(rate_hz / unit.seconds)) continue;
    return fmt::format("--time-unit {} (or {})", unit.name, unit.name == "ms" ? "us" : "ms");
  }
  return "in what they are (--time-unit)";
}

}  // namespace fingerpad
