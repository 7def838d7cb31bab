#pragma once

#include <array>
#include <vector>

#include "study/profile_fit.hpp"

namespace fingerpad {

/// The mean share of friction that a rupture may drop unseen.
double unseen_drop_share(const std::vector<TrialEvidence>& trials);

/// How far mu_dynamic may be off where what passes for slip may hold teeth.
double teeth_reach(const ProfileFit& fit, const FitPoint& point);

/// How far each number moves.
using NumberReaches = std::array<double, pad_number_keys.size()>;

/// How far other evidence of the same trials moves what both tell.
NumberReaches moved_by(const std::vector<TrialEvidence>& evidence, const ProfileFit& fit,
                       const FitPoint& point);

/// What a delay that is not known does to each number.
struct DelayReach {
  NumberReaches moved{};                               ///< at most
  std::array<bool, pad_number_keys.size()> is_lost{};  ///< with it, it is told no more

  /// Takes in what the trials say of such a delay (delayed_evidence).
  void add(const std::vector<TrialEvidence>& delayed, const ProfileFit& fit, const FitPoint& point);
};

/// How far each number moves where the noise of the sensors is a tenth more than was taken off, and ruptures
/// lie a twentieth of a sample later than in its middle (and what a slow sensor shows them late, where that
/// is not taken out; of a bent spring by its share more); ends of slip that pass for stick bend a spring by a
/// thousandth and lengthen it by half of that, and one that is told by weak pulls alone, as where stick may
/// hide, by a twelfth of its own share more; a mains line that is left in pulls at ruptures with all of its
/// amplitude; slow slip that is left in mu_dynamic is half a thousandth of it, and twice as much where stick
/// hides in it.
/// @param by_delay  how far the delay moves it (delayed_evidence), and what else is known of that kind
NumberReaches moved_by_sampling(const ProfileFit& fit, const NumberReaches& by_delay, const FitPoint& point,
                                bool has_slow_slip);

}  // namespace fingerpad
