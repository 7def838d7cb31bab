#pragma once

#include <string>
#include <vector>

#include "study/trial_evidence.hpp"

namespace fingerpad {

/// One axis of the stick ellipse over the finger's angle, per unit of mu_s; see pad_numbers.
struct StickAxisFit {
  double compliance45_m = 0;  ///< mean over subjects of 1/K at 45 deg: the axis is mu_s times it
  double slope_per_deg = 0;
  long samples = 0, trials = 0;
  std::string axis_refusal, slope_refusal;  ///< empty: the number holds
};

/// @param axis  0 lateral, 1 longitudinal
StickAxisFit fit_stick_axis(const std::vector<TrialEvidence>& trials, const std::vector<int>& times,
                            int axis);

}  // namespace fingerpad
