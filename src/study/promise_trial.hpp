#pragma once

#include <vector>

#include "study/judged_cases.hpp"

namespace fingerpad {

/// Where a promise is tried that speaks of more than a case's own ways.
///
/// `auto` chooses by the part, not by a motion, and promises for every way that stays in a region of it, up
/// to the greatest force. So a case's parts are touched by strokes in those regions in which reckoning has
/// each method with each kind of normals at its worst, and all over; lightly, hard, and as hard as may be.
/// Each entry is such a case, of the ways in one region with one press, to be judged by itself: a finger may
/// stay there.
std::vector<JudgedCase> promise_trials(const JudgedCase& one);

}  // namespace fingerpad
