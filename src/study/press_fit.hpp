#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/trial_evidence.hpp"

namespace fingerpad {

/// How the pad yields along the plate's normal: n = (depth/B)^(1/w) in N.
struct PressFit {
  double depth_at_1_n_m = 0;  ///< B, mean over subjects whose height moves
  double exponent = 0;  ///< w, likewise; what is to be tried next where it is not found yet, 0 where none is
  long samples = 0, trials = 0;
  std::string refusal;  ///< empty: it holds
};

/// @param about  the exponent w that the trials' sums were taken about
PressFit fit_press(const std::vector<TrialEvidence>& trials, const std::vector<int>& times, double about);

/// B as one trial alone says it at the exponent that its sums were taken about; nothing where its height does
/// not move, rises as it is pressed or is explained by the force to less than a half, or its load hardly
/// changes.
std::optional<double> own_depth_at_1_n_m(const TrialEvidence& trial);

}  // namespace fingerpad
