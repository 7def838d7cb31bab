#pragma once

#include <string>
#include <vector>

#include "study/profile_fit.hpp"
#include "study/sampling_reach.hpp"

namespace fingerpad {

inline constexpr double widest_axis_m = 0.01, narrowest_axis_m = 0.1e-3;  ///< of a finger's

/// Refuses what fewer than three trials tell, where it is a v_min, a vibration or an axis that is no
/// finger's; and a vibration that many draws of the trials do not show, or whose bandwidth may be none.
void refuse_told_by_few(ProfileFit& fit);

/// Whether a number that rests on stick is given without an interval.
bool is_bare_spring(const ProfileFit& fit);

/// Of these, refuses those that may be off by more than a fifth by chance within the trials alone: an axis
/// with all that rests on its stick, a bend or a loop by itself.
/// @param reach  reach_by_stretches
void refuse_unsteady_springs(const NumberReaches& reach, ProfileFit& fit);

/// Refuses a mu_dynamic without an interval where no slip is surely seen: nothing says then how far the teeth
/// that may pass for slip reach.
void refuse_unsure_slip(ProfileFit& fit);

/// Why a number has no interval, in short.
std::string no_interval_words(NoInterval why);

/// Which numbers have no interval and what to do about it, one for each reason; empty where all have one.
std::vector<std::string> without_interval_words(const ProfileFit& fit);

}  // namespace fingerpad
