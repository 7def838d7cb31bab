#pragma once

#include <string>
#include <vector>

#include "study/profile_fit.hpp"
#include "study/sampling_reach.hpp"

namespace fingerpad {

/// Refuses what rests on stick.
void refuse_springs(RefusalReason reason, const std::string& words, PadValues& values);

/// Where no delay of force behind position is told, and none was taken out, refuses what one would move by
/// much.
/// @param moved  by a delay as sensors have it
void refuse_by_delay(const NumberReaches& moved, ProfileFit& fit);

/// Likewise a normal law that one would hide, or that many draws of the trials do not tell: pressing and
/// lifting then part so far that the height hardly follows the force, and any exponent may come of it.
void refuse_law_lost_by_delay(const DelayReach& reach, ProfileFit& fit);

/// Says that teeth which may pass for slip make mu_dynamic's interval wide.
/// @param reach  teeth_reach
void tell_teeth(double reach, ProfileFit& fit);

/// A law that leaves somewhat too much where no delay was taken out may fit.
void doubt_misfit(LawResidual& residual);

/// Which trials' springs along an axis are unlike the others' (ProfileFit::outliers); empty where none are.
/// @param axis  lateral_axis or longitudinal_axis
std::string odd_spring_words(const ProfileFit& fit, PadNumber axis);

/// An axis that its interval does not tell to half of it is refused, with what rests on the same, and names
/// trials that may be why.
/// @param keeps_told_by_few  FitSettings'
void refuse_vague_springs(bool keeps_told_by_few, ProfileFit& fit);

/// The finger-pad law takes a cubic_share of 0 to 1. One that noise puts outside is left if its interval
/// reaches into that. One that is a little below 0 is a straight spring's, some of whose ends pass for stick:
/// its interval reaches to 0.
void refuse_odd_cubic_shares(ProfileFit& fit);

/// Where nothing tells where stick ends (mu_static is refused, and not for the force's zero alone), springs
/// are told as straight ones: says so, and what a bend would make of it.
void doubt_straight_springs(ProfileFit& fit);

/// Where mu_static comes out below mu_dynamic, says what they came to; where it is told by each trial's own
/// slip (FitPoint::pairs_friction), that it is. And which trials are unlike one another, and what may be why.
void tell_unlike_friction(const std::vector<std::string>& names, const FitPoint& point, ProfileFit& fit);

/// Says of coefficients that are refused that noise may be why.
void tell_noise(const std::vector<StickSegments>& segments, ProfileFit& fit);

}  // namespace fingerpad
