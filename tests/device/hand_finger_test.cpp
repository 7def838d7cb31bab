#include "device/hand_finger.hpp"

#include <gtest/gtest.h>

namespace fingerpad::hand_finger_test {
namespace {

TEST(HandFinger, ChasesTheMouseAndIsHeldUpByTheSurface) {
  Scene scene;
  scene.motion.rate_hz = 1000;
  HandSettings hand;
  hand.stiffness_n_per_m = 200;
  hand.damping_n_s_per_m = 5;
  const FingerSample start{0, Vec3(0, 0, 0.01), Vec3::UnitY()};
  HandFinger finger({scene, nullptr, start, {}, hand}, 1e-3);
  finger.set_target({0, Vec3(0.02, 0, -0.01), Vec3::UnitY()});
  FingerSample sample;
  for (int k = 0; k < 3000; ++k) {
    sample = finger.advance(1e-3);
    TickRecord tick;
    if (sample.p_WQ.z() < 0) {
      tick.phase = Phase::slip;
      tick.force_W_n = Vec3(0, 0, -1000 * sample.p_WQ.z());
    }
    finger.feel(tick);
  }
  EXPECT_NEAR(sample.p_WQ.x(), 0.02, 1e-6);
  // 200 N/m pull down to -10 mm, 1000 N/m push up: at rest where they balance.
  EXPECT_NEAR(sample.p_WQ.z(), -0.01 * 200 / 1200, 1e-6);
}

}  // namespace
}  // namespace fingerpad::hand_finger_test
