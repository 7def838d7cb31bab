#pragma once

#include <cstddef>
#include <vector>

#include "study/trial_evidence.hpp"

namespace fingerpad {

/// What the trials say where the delay is as much more as it may be off: positions of a moment later.
/// @param times  as much; below 0: earlier
std::vector<TrialEvidence> delayed_evidence(const Measurement& measurement,
                                            const std::vector<StickSegments>& segments,
                                            const EvidencePoint& about, double delay_left_s, double times);

/// A trial's heights of a moment later, by their slope over so many samples either way.
void delay_heights(MeasuredTrial& trial, std::size_t half_window, double by_s);

}  // namespace fingerpad
