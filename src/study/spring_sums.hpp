#pragma once

#include "study/trial_evidence.hpp"

namespace fingerpad {

/// Adds a trial's stretches of stick to its evidence.
/// @param ratio  the force ratios at the load that the evidence is taken at
/// @param about  where it knows the delay, the term of speed stays empty
void add_spring_sums(const MeasuredTrial& trial, const StickSegments& segments,
                     const std::vector<Vec2>& ratio, const EvidencePoint& about, TrialEvidence& evidence);

/// How far the spring of a trial's own stick gives way along a direction to a force ratio; 0: not known.
/// @param bend  that the evidence was taken about
double spring_way_m(const TrialEvidence& evidence, const std::array<SpringBend, 2>& bend, const Vec2& forward,
                    double pull);

/// What the ratio rises a metre there; 0: not known.
double spring_stiffness_per_m(const TrialEvidence& evidence, const std::array<SpringBend, 2>& bend,
                              const Vec2& forward, double pull);

}  // namespace fingerpad
