#include "device/hand_finger.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace fingerpad::hand_finger_test {
namespace {

TEST(HandFinger, ChasesTheMouseAndIsHeldUpByTheSurface) {
  Scene scene;
  scene.motion.rate_hz = 1000;
  HandSettings hand;
  hand.stiffness_n_per_m = 200;
  hand.damping_n_s_per_m = 5;
  hand.encoder_m = 0;
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

TEST(HandFinger, IsFeltWhereItsEncodersPutItAndPushesWithItsSpring) {
  Scene scene;
  scene.motion.rate_hz = 1000;
  HandSettings hand;
  hand.stiffness_n_per_m = 200;
  hand.damping_n_s_per_m = 5;
  hand.encoder_m = 1e-4;
  const FingerSample start{0, Vec3(0, 0, 0.01), Vec3::UnitY()};
  HandFinger finger({scene, nullptr, start, {}, hand}, 1e-3);
  EXPECT_TRUE(finger.gives().pushes);
  finger.set_target({0, Vec3(0.02, 0, 0.01), Vec3::UnitY()});
  double most_off_m = 0;
  for (int k = 0; k < 300; ++k) {
    const FingerSample sample = finger.advance(1e-3);
    const Vec3 steps = sample.p_WQ / 1e-4;
    EXPECT_LT((steps - Vec3(steps.array().round())).norm(), 1e-9);
    most_off_m = std::max(most_off_m, (sample.p_WQ - finger.true_place_W().value()).cwiseAbs().maxCoeff());
    // On the way it is drawn along x, and by nothing else.
    if (k == 20) {
      EXPECT_GT(sample.push_W_n.x(), 0.1);
    }
    EXPECT_NEAR(sample.push_W_n.y(), 0, 1e-12);
    finger.feel({});
  }
  EXPECT_GT(most_off_m, 2e-5);
  EXPECT_LE(most_off_m, 0.5e-4 + 1e-12) << "half a step";
}

}  // namespace
}  // namespace fingerpad::hand_finger_test
