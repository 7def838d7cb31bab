#pragma once

#include <string>
#include <vector>

#include "study/trial_evidence.hpp"

namespace fingerpad {

/// What all trials share of an axis' spring: the coefficients of SpringTerm beside the compliance A.
struct SpringShape {
  double share_left = 0;    ///< e: what the cubic share is beyond that of the terms' bend
  double hysteresis_m = 0;  ///< h: half the width of the loop along the displacement
  double delay_s = 0;       ///< d: what is left of a delay
};

/// A of a trial, the shape being known.
double spring_compliance_m(const SpringSums& sums, const SpringShape& shape);

/// Whether a trial's stick pushes along an axis (0 lateral, 1 longitudinal), and its spring holds the finger
/// back: else it is none of the axis' trials.
bool pushes_along(const TrialEvidence& trial, std::size_t axis);

/// One axis of the stick ellipse and its spring, over the finger's angle; see pad_numbers.
struct SpringFit {
  double compliance45_m = 0;  ///< A: mean over subjects at 45 deg; A mu_s is the axis
  double straight45_m = 0;    ///< likewise of the straight line through all of stick
  double slope_per_deg = 0;
  SpringShape shape;
  double linearity = 0;  ///< share of the displacement's variance that a straight line explains
  long samples = 0, trials = 0;
  std::string axis_refusal, slope_refusal, shape_refusal, hysteresis_refusal;  ///< empty: the number holds
};

/// @param times  how often each trial counts
/// @param axis   0 lateral, 1 longitudinal
SpringFit fit_spring(const std::vector<TrialEvidence>& trials, const std::vector<int>& times, int axis);

}  // namespace fingerpad
