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
};

}  // namespace fingerpad
