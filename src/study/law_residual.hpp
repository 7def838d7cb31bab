#pragma once

#include <vector>

#include "study/spring_fit.hpp"

namespace fingerpad {

/// Sums of squares of force ratios, over groups of samples.
struct ResidualPart {
  double left = 0;  ///< what the law leaves
  double expected =
      0;  ///< what the sensors' noise, and slip further from its ends (the vibration), explain of it
  double signal = 0;  ///< the force ratios themselves
  long samples = 0;

  ResidualPart& operator+=(const ResidualPart& other) noexcept;
};

/// What the pad's law leaves of one trial where it says most: in stick, and in slip within 50 ms of its ends.
struct TrialResidual {
  ResidualPart stick, slip;
  ResidualPart sure_stick;    ///< of stick that surely does not give way unseen (surest_pull)
  long gives = 0, drops = 0;  ///< TrialEvidence's
};

/// The spring that was fitted to all trials, which the law is held against.
struct LawSpring {
  EvidencePoint about;               ///< that the evidence was taken about
  std::array<SpringShape, 2> shape;  ///< lateral, longitudinal
  bool leaves_hidden_out = false;    ///< stick is held against it where it surely does not give way unseen
};

/// Holds the law against one trial: in stick each stretch is the fitted spring, bent and with its loop, of
/// the trial's own compliance; in slip the force ratio is the trial's mean.
TrialResidual trial_residual(const MeasuredTrial& trial, const StickSegments& segments,
                             const TrialEvidence& evidence, const LawSpring& spring);

/// The force ratios of a trial as they would be at the law's load.
std::vector<Vec2> ratio_at_load(const MeasuredTrial& trial, const MuLoadLaw& load);

}  // namespace fingerpad
