#include "study/recorders_rate.hpp"

namespace fingerpad {

bool is_recorders_rate(double rate_hz) {
  constexpr double slowest_hz = 50, fastest_hz = 20e3;
  return rate_hz >= slowest_hz && rate_hz <= fastest_hz;
}

std::string unit_of_seconds_words(double rate_hz) {
  constexpr double us_per_s = 1e6;
  return is_recorders_rate(us_per_s * rate_hz) ? "--time-unit us (or ms)" : "--time-unit ms (or us)";
}

}  // namespace fingerpad
