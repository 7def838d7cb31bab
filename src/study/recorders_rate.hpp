#pragma once

#include <string>

namespace fingerpad {

/// Whether fingers are recorded at such a rate.
bool is_recorders_rate(double rate_hz);

/// "--time-unit ms (or us)": what to say of the times of a table that were taken as seconds and make no
/// recorder's rate, the unit first in which they do; "in what they are (--time-unit)" where none makes one.
std::string unit_of_seconds_words(double rate_hz);

}  // namespace fingerpad
