#pragma once

#include <string>

namespace fingerpad {

/// Whether fingers are recorded at such a rate.
bool is_recorders_rate(double rate_hz);

/// "--time-unit ms (or us)": what the times of a table may be, the likeliest first, where they were taken as
/// seconds and make no recorder's rate.
std::string unit_of_seconds_words(double rate_hz);

}  // namespace fingerpad
