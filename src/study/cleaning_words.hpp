#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "study/mains_hum.hpp"
#include "study/measurement.hpp"

namespace fingerpad {

// What cleaning has done, for people.

/// What was done about hum, and what looks like it and was left in.
/// @param taken    of each trial that senses what may hum
/// @param of_what  of the trials
std::string hum_text(const std::vector<MainsHum>& taken, const std::vector<std::string>& left_in,
                     bool of_forces, std::string_view of_what);

/// Where contact points come from, and what they are beside a finger that was tracked; none where nothing
/// tells them.
std::vector<std::string> contact_steps(const std::vector<TrialCleaning>& trials);

/// All that was done, in order.
/// @param hum  hum_text of all that may hum
std::vector<std::string> steps_text(const Measurement& measurement, const CleaningSettings& settings,
                                    const std::vector<std::string>& hum);

}  // namespace fingerpad
