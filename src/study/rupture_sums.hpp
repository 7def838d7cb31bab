#pragma once

#include "study/trial_evidence.hpp"

namespace fingerpad {

/// Adds the force ratios at which a trial's stick gives way.
/// @param bend  that the evidence's springs were taken about
void add_rupture_sums(const MeasuredTrial& trial, const StickSegments& segments,
                      const std::vector<Vec2>& ratio, const std::array<SpringBend, 2>& bend,
                      TrialEvidence& evidence);

}  // namespace fingerpad
