#pragma once

#include "study/trial_evidence.hpp"

namespace fingerpad {

/// Adds the force ratios at which a trial's stick gives way.
/// @pre  its slip and its springs have been added
void add_rupture_sums(const MeasuredTrial& trial, const StickSegments& segments,
                      const std::vector<Vec2>& ratio, const EvidencePoint& about, TrialEvidence& evidence);

/// By how many samples the force sensor's drops at ruptures are late, as of a low pass; 0 where too few tell
/// it. Two at the most.
double seen_rupture_lag(const std::vector<TrialEvidence>& trials);
/// The same, where it is more than a twenty-fifth of a sample, and so is taken out (EvidencePoint); else 0.
double rupture_lag(const std::vector<TrialEvidence>& trials);

/// Samples behind a rupture in which the force sensor still shows its drop (StickSegments); 0: it shows it at
/// once. Where too few of many drops tell that, and samples are 1.7 ms apart or more, one: a low pass of 300
/// Hz takes a third of that.
std::size_t drop_tail_samples(const std::vector<TrialEvidence>& trials);

}  // namespace fingerpad
