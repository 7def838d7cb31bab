#pragma once

#include "study/trial_evidence.hpp"

namespace fingerpad {

/// Adds the force ratios at which a trial's stick gives way.
/// @pre  its slip and its springs have been added
void add_rupture_sums(const MeasuredTrial& trial, const StickSegments& segments,
                      const std::vector<Vec2>& ratio, const EvidencePoint& about, TrialEvidence& evidence);

}  // namespace fingerpad
