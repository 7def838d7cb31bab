#pragma once

#include <optional>

#include "fingerpad/attitude.hpp"
#include "fingerpad/types.hpp"

namespace fingerpad {

/// The finger at one tick.
struct FingerSample {
  double t_s = 0;                        ///< time [s]; ticks are told apart by the rate, not by it
  Vec3 p_WQ = Vec3::Zero();              ///< Q, the finger's place in the world [m]
  Vec3 direction_W{0, 0.7071, -0.7071};  ///< unit, along the distal phalanx towards the tip
  Vec3 push_W_n = Vec3::Zero();          ///< what pushes the finger, where a hand is simulated [N]
  std::optional<Attitude> attitude{};    ///< how the finger is turned, where that is known: unit, finger to W
  /// The normal force as it was measured, in place of the model's; none where it is not above 0 [N]. Where
  /// the finger touches nothing there is no force all the same.
  std::optional<double> normal_force_n{};
  std::optional<Vec3> velocity_W{};  ///< where it is known better than from two places; else from those [m/s]
};

}  // namespace fingerpad
