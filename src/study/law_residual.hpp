#pragma once

#include <string>
#include <vector>

#include "study/spring_fit.hpp"

namespace fingerpad {

/// How well the pad's law repeats the measured forces where it says most: in stick, and in slip within 50 ms
/// of its ends.
struct LawResidual {
  double share = 0;     ///< RMS of what it leaves of the force ratio, over the RMS of that
  double expected = 0;  ///< likewise, of the sensors' noise and of slip further from its ends (the vibration)
  long samples = 0;
  long gives = 0, drops = 0;  ///< ends of stick in slip; of these, with a drop of the force (ruptures)
  std::string
      misfit;  ///< why the pad's law does not fit; empty where it does, or too little is there to tell
};

/// The spring that was fitted to all trials, which the law is held against.
struct LawSpring {
  EvidencePoint about;               ///< that the evidence was taken about
  std::array<SpringShape, 2> shape;  ///< lateral, longitudinal
  bool leaves_hidden_out = false;  ///< what of stick hides is surely the pad's own: friction's step tells it
};

/// What of stick may hide, which is no fault of the law.
struct HiddenStick {
  bool is_likely = false;   ///< it passes for slip: what slip's ends leave says nothing
  bool is_stepped = false;  ///< and friction's step tells it: its ruptures are not to be seen
  double unseen_drop = 0;   ///< share of friction that a rupture may drop unseen
};

/// Holds the law against one trial: in stick each stretch is the fitted spring, bent and with its loop, of
/// the trial's own compliance; in slip the force ratio is the trial's mean.
class ResidualSums {
 public:
  explicit ResidualSums(const LawSpring& spring) : spring_(spring) {}
  void add(const MeasuredTrial& trial, const StickSegments& segments, const TrialEvidence& evidence);
  LawResidual verdict(const HiddenStick& hidden) const;

 private:
  void add_stick(const MeasuredTrial& trial, const StickSegments& segments, const TrialEvidence& evidence,
                 const std::vector<Vec2>& ratio);
  void add_slip(const StickSegments& segments, const std::vector<Vec2>& ratio, double rate_hz);

  LawSpring spring_;
  double left_ = 0, expected_ = 0, signal_ = 0;  // squares
  long samples_ = 0, gives_ = 0, drops_ = 0;
};

/// The force ratios of a trial as they would be at the law's load.
std::vector<Vec2> ratio_at_load(const MeasuredTrial& trial, const LoadLaw& load);

}  // namespace fingerpad
