#pragma once

#include <array>

#include "study/trial_evidence.hpp"

namespace fingerpad {

/// How far the spring of a trial's own stick gives way along a direction to a force ratio, at the load that
/// springs are taken to; 0: not known.
/// @param bend  that the evidence was taken about
double spring_way_m(const TrialEvidence& evidence, const std::array<SpringBend, 2>& bend, const Vec2& forward,
                    double pull);

/// What the ratio rises a metre there; 0: not known.
double spring_stiffness_per_m(const TrialEvidence& evidence, const std::array<SpringBend, 2>& bend,
                              const Vec2& forward, double pull);

}  // namespace fingerpad
