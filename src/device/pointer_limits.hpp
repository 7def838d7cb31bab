#pragma once

#include <limits>

/// The numbers by which the pointer's finger presses, follows, lands and lifts.
namespace fingerpad::pointer_limits {

/// A step is made where it leaves the force below so many times what is asked for. Less than twice: what
/// foresight cannot tell, as vibration, comes on top.
inline constexpr double tried_share = 1.5, surely_share = 1.8;
/// A shorter one that keeps it below so many times is preferred.
inline constexpr double gentle_share = 1.05;
/// Where there is nothing else to do.
inline constexpr double any_force_n = std::numeric_limits<double>::infinity();
/// How soon a pressed finger follows the pointer aside, and how fast it goes at most [sizes of the parts a
/// second].
inline constexpr double aside_per_s = 50, fastest_per_s = 8, slow_share = 0.05;
/// After a pointer that rests it goes so long, and then less and less in this time, until hardly anything is
/// left.
inline constexpr double following_s = 0.25, fading_s = 0.05, nothing_left = 1e-3;
/// At rest it goes on for its force until it has gone so far, in what a flight keeps from the parts; from
/// then on only while the force is off by more than this share.
inline constexpr double gone_share = 0.1, force_tolerated = 0.15;
/// So long it flies after a pointer that rests; then it has come as near as it can, and slows down to rest in
/// this time.
inline constexpr double flying_s = 3, flying_fading_s = 0.5;
/// What is farther from the finger than this does not lead it over the surface [sizes of the parts] ...
inline constexpr double leash_share = 0.25;
/// ... nor what it has come no nearer to, by this share, for this time.
inline constexpr double leash_s = 0.2, leash_gain = 0.02;
/// How fast it comes down where nothing is near yet, and goes up [m/s].
inline constexpr double landing_m_per_s = 0.3, lifting_m_per_s = 0.5;
/// What no way led to is tried for anew where the eye's direction has turned by more than this [rad].
inline constexpr double another_view = 0.1;
/// A press that is let go within so long is made all the same, until it has pressed with this share of what
/// it asked for, or so long after it began: the finger may still be on its way from far off.
inline constexpr double tap_s = 0.3, tap_share = 0.5, tap_waits_s = 1;
/// The pointer's pace is told from so much of its way; it leads the finger on by no more than a share of the
/// parts' size.
inline constexpr double pace_s = 0.03, most_lead_share = 0.1;
/// After so many ticks of a lift every tick is to ease the force.
inline constexpr int most_lift_ticks = 100;
/// How often a step is halved before the finger does something else.
inline constexpr int most_halvings = 4;
/// How often one that gives way doubles what it goes in a tick: until that is farther than any finger is
/// deep.
inline constexpr int most_doublings = 16;

}  // namespace fingerpad::pointer_limits
