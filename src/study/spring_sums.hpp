#pragma once

#include <vector>

#include "study/phase_stretch.hpp"
#include "study/trial_evidence.hpp"

namespace fingerpad {

/// One group's means of what SpringTerm lists, along one axis.
using SpringTerms = Eigen::Matrix<double, 6, 1>;

constexpr double spring_group_s = 4e-3;

/// A stretch of stick as means over groups of samples.
struct SpringGroups {
  PhaseStretch stretch;
  std::size_t size = 1;                           ///< samples of a group, spring_group_s or less
  std::vector<std::array<SpringTerms, 2>> terms;  ///< lateral, longitudinal
  std::vector<double> longer;                     ///< EvidencePoint::axes_at, of each
  bool is_short = false;                          ///< the stretch gave smaller groups than that
};

/// The force ratio up to which a trial's stick is surely one: three quarters of friction in slip (of all
/// trials, if it does not slip), which is no more than half way from mu_dynamic to mu_static. Endless where
/// no stick hides.
double surest_pull(const TrialEvidence& evidence, const EvidencePoint& about);

/// What of stick is taken.
struct SpringChoice {
  const EvidencePoint& about;  ///< where it knows the delay, the term of speed stays empty
  double most_pull;            ///< surest_pull: groups of more are left out, and part stretches
};

/// All stretches of a trial's stick that are long enough for three groups.
/// @param ratio  the force ratios at the load that the evidence is taken at
std::vector<SpringGroups> spring_groups(const MeasuredTrial& trial, const StickSegments& segments,
                                        const std::vector<Vec2>& ratio, const SpringChoice& choice);

/// How the terms of the spring along an axis (first row: of its bend, second: of the cubic share) change with
/// the ratio, along it (first column) and across.
Eigen::Matrix2d spring_slopes(const SpringBend& bend, const Vec2& own_and_other);

/// Adds a trial's stretches of stick to its evidence; parameters as spring_groups.
/// @pre  its slip has been added
void add_spring_sums(const MeasuredTrial& trial, const StickSegments& segments,
                     const std::vector<Vec2>& ratio, const EvidencePoint& about, TrialEvidence& evidence);

/// What a trial's stick alone says.
TrialEvidence spring_evidence(const MeasuredTrial& trial, const StickSegments& segments);

}  // namespace fingerpad
