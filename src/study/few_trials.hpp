#pragma once

#include "study/profile_fit.hpp"

namespace fingerpad {

/// Refuses numbers that are worth nothing without an interval, or whose interval says that nothing was
/// found: v_min of one or two trials, which a single wrong end of slip moves anywhere; and the vibration
/// where the bandwidth's interval holds 0, where it is narrower than the spectrum's step, or where the trials
/// as they are drawn do not all show a peak.
void refuse_untold(ProfileFit& fit);

/// The numbers that are given though too few trials tell how far they may be off, in words; empty if none is.
std::string without_interval_words(const ProfileFit& fit);

}  // namespace fingerpad
