#pragma once

#include <string>
#include <string_view>

namespace fingerpad {

/// ", 2.5 jobs/s, 40 s left"; nothing before anything can be said.
/// @param done  of `total` things in `seconds`; a share of one counts as such
/// @param many  what they are called: "jobs"
std::string pace_words(double done, double total, double seconds, std::string_view many);

}  // namespace fingerpad
