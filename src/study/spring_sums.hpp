#pragma once

#include "study/trial_evidence.hpp"

namespace fingerpad {

/// Adds a trial's stretches of stick to its evidence.
/// @param ratio  the force ratios at the load that the evidence is taken at
/// @param about  where it knows the delay, the term of speed stays empty
void add_spring_sums(const MeasuredTrial& trial, const StickSegments& segments,
                     const std::vector<Vec2>& ratio, const EvidencePoint& about, TrialEvidence& evidence);

/// The stiffness per newton along a direction, of the trial's own stick; 0: not known.
double stiffness_along(const TrialEvidence& evidence, const Vec2& forward);

}  // namespace fingerpad
