#pragma once

#include <string>
#include <vector>

#include "study/law_residual.hpp"

namespace fingerpad {

/// Whether the pad's law repeats the measured forces.
struct LawResidual {
  double share = 0;     ///< RMS of what it leaves of the force ratio, over the RMS of that
  double expected = 0;  ///< likewise, of the sensors' noise and of slip further from its ends (the vibration)
  long samples = 0;
  long gives = 0, drops = 0;  ///< ends of stick in slip; of these, with a drop of the force (ruptures)
  std::string
      misfit;  ///< why the pad's law does not fit; empty where it does, or too little is there to tell
  std::string untold;  ///< why that cannot be told; empty where it can
  std::vector<std::string>
      odd_trials;  ///< that the law does not fit, though it fits most: "NAME: it leaves .."
};

/// What of stick may hide, which is no fault of the law.
struct HiddenStick {
  bool is_likely = false;   ///< it passes for slip: what slip's ends leave says nothing
  bool is_stepped = false;  ///< and friction's step tells it: its ruptures are not to be seen
  double unseen_drop = 0;   ///< share of friction that a rupture may drop unseen
  std::string no_slip;      ///< unseen_slip_words: stick alone is held against the law
};

/// The law does not fit where it leaves too much of the trials together, and of most of them by what they
/// weigh: one trial in which a marker slipped says nothing of the finger.
/// @param names  of the trials
LawResidual law_verdict(const std::vector<TrialResidual>& trials, const std::vector<std::string>& names,
                        const HiddenStick& hidden);

}  // namespace fingerpad
