#pragma once

#include "study/trial_evidence.hpp"

namespace fingerpad {

/// Adds the force ratios at which a trial's stick gives way.
void add_rupture_sums(const MeasuredTrial& trial, const StickSegments& segments,
                      const std::vector<Vec2>& ratio, TrialEvidence& evidence);

}  // namespace fingerpad
