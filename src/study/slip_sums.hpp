#pragma once

#include "study/phase_stretch.hpp"
#include "study/trial_evidence.hpp"

namespace fingerpad {

/// Adds what a trial's slip says: mean ratio, its change with the load, and the spectrum. Its ends that are
/// slower than v_min are left out.
void add_slip_sums(const MeasuredTrial& trial, const StickSegments& segments, const std::vector<Vec2>& ratio,
                   const EvidencePoint& about, TrialEvidence& evidence);

/// Adds the speeds at which its slip ends in stick, told along the spring of the evidence.
void add_stop_sums(const MeasuredTrial& trial, const StickSegments& segments, const std::vector<Vec2>& ratio,
                   const EvidencePoint& about, TrialEvidence& evidence);

/// A stretch of slip without what is slower at its ends than v_min, and a little more, since a trial's own
/// may be higher.
PhaseStretch fast_part(PhaseStretch stretch, const StickSegments& segments, double v_min_m_per_s);

}  // namespace fingerpad
