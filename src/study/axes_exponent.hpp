#pragma once

#include <optional>
#include <vector>

#include "study/trial_evidence.hpp"

namespace fingerpad {

/// The stiffness that one trial's stick has along an axis (0 lateral, 1 longitudinal), as force ratio over
/// displacement [1/m], at the load that its sums were taken to; nothing where it says little.
std::optional<double> own_stiffness(const TrialEvidence& trial, std::size_t axis);

/// How the axes of stick go with the load: axes ~ n^value, and a spring's stiffness in N/m, which is friction
/// over axis, with mu(n) n^(1 - value). The pad's law has 0.
struct AxesExponent {
  double value = 0;
  double deviation = 0;  ///< standard, of that
  std::size_t trials = 0;
};

/// The median of the slopes between any two trials of one subject, angle and axis, over the logarithms of
/// their stiffnesses and loads (Theil 1950, Sen 1968), each counting as much as the loads differ. Nothing
/// where trials are few or alike in load, or where it may be 0: it is less than four of its deviations (of
/// the trials about it, on the median), or less than 0.1.
/// @param about  EvidencePoint::axes_exponent that the sums were taken about
std::optional<AxesExponent> axes_exponent(const std::vector<TrialEvidence>& trials, double about);

}  // namespace fingerpad
