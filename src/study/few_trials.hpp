#pragma once

#include <string>
#include <vector>

#include "study/profile_fit.hpp"

namespace fingerpad {

/// Refuses what fewer than three trials tell, where it is a v_min, a vibration or an axis that is no
/// finger's; and a vibration that many draws of the trials do not show, or whose bandwidth may be none.
void refuse_told_by_few(ProfileFit& fit);

/// Why a number has no interval, in short.
std::string no_interval_words(NoInterval why);

/// Which numbers have no interval and what to do about it, one for each reason; empty where all have one.
std::vector<std::string> without_interval_words(const ProfileFit& fit);

}  // namespace fingerpad
