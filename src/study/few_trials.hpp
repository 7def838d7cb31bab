#pragma once

#include <string>

#include "study/profile_fit.hpp"

namespace fingerpad {

/// Refuses what too few trials tell, and what may be nothing at all: v_min and vibrations that have no
/// interval, a vibration whose bandwidth may be none, and an axis without an interval that is no finger's.
void refuse_told_by_few(ProfileFit& fit);

/// Which numbers have no interval, and what to do about it; empty where all have one.
std::string without_interval_words(const ProfileFit& fit);

}  // namespace fingerpad
