#include "motion/simulated_hand.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace fingerpad::simulated_hand_test {
namespace {

HandSettings exact_hand() {
  HandSettings settings;
  settings.encoder_m = 0;
  return settings;
}

TEST(SimulatedHand, FallsBackToItsMotionAsADampedOscillator) {
  HandSettings settings = exact_hand();
  settings.mass_kg = 0.1;
  settings.damping_n_s_per_m = 0.5;
  settings.stiffness_n_per_m = 100;
  SimulatedHand hand(settings, 1e-3);
  hand.start(Vec3(0.01, 0, 0));
  for (int k = 0; k < 500; ++k) hand.advance(Vec3::Zero(), Vec3::Zero(), Vec3::Zero());
  const double decay = 0.5 / (2 * 0.1), omega = std::sqrt(100 / 0.1 - decay * decay), t = 0.5;
  const double x = 0.01 * std::exp(-decay * t) * (std::cos(omega * t) + decay / omega * std::sin(omega * t));
  EXPECT_NEAR(hand.position_W().x(), x, 1e-14);  // exact but for rounding over 500 products
}

TEST(SimulatedHand, FollowsARampAtTheSameLagWhateverTheTick) {
  for (const double dt : {1e-4, 1e-3, 1e-2}) {
    SimulatedHand hand(exact_hand(), dt);
    hand.start(Vec3::Zero());
    const double v = 0.1;
    const int n = static_cast<int>(std::lround(20 / dt));
    for (int k = 0; k < n; ++k)
      hand.advance(Vec3(v * k * dt, 0, 0), Vec3(v * (k + 1) * dt, 0, 0), Vec3::Zero());
    EXPECT_NEAR(v * 20 - hand.position_W().x(), 0.5 * v / 200, 1e-11) << dt;  // b v / k, transients long gone
  }
}

TEST(SimulatedHand, HoldsAConstantForceAtItsDeflection) {
  SimulatedHand hand(exact_hand(), 1e-3);
  hand.start(Vec3::Zero());
  for (int k = 0; k < 20000; ++k) hand.advance(Vec3::Zero(), Vec3::Zero(), Vec3(0, 0, 1));
  EXPECT_NEAR(hand.position_W().z(), 1.0 / 200, 1e-12);
}

TEST(SimulatedHand, ShowsAForceTheGivenTicksLate) {
  HandSettings settings = exact_hand();
  settings.delay_ticks = 3;
  SimulatedHand hand(settings, 1e-3);
  hand.start(Vec3::Zero());
  for (int k = 0; k < 6; ++k) {
    EXPECT_EQ(hand.position_W().x() != 0, k > 3) << k;
    hand.advance(Vec3::Zero(), Vec3::Zero(), Vec3(k == 0 ? 1 : 0, 0, 0));
  }
}

TEST(SimulatedHand, DryFrictionStopsItExactlyAndThenHoldsIt) {
  // No spring, no damper: v0^2/(2 a) with a = f_c/m, at v0/a; then rest.
  HandSettings settings = exact_hand();
  settings.stiffness_n_per_m = 0;
  settings.damping_n_s_per_m = 0;
  settings.coulomb_n = 0.2;
  settings.mass_kg = 0.1;
  SimulatedHand hand(settings, 1e-2);
  hand.start(Vec3::Zero());
  hand.advance(Vec3::Zero(), Vec3::Zero(), Vec3(1.2, 0, 0));  // 10 m/s^2 net for 10 ms: 0.1 m/s after 0.5 mm
  for (int k = 0; k < 30; ++k) hand.advance(Vec3::Zero(), Vec3::Zero(), Vec3::Zero());
  EXPECT_NEAR(hand.position_W().x(), 0.0005 + 0.1 * 0.1 / (2 * 2), 1e-14);
  const double rest = hand.position_W().x();
  hand.advance(Vec3::Zero(), Vec3::Zero(), Vec3(0.19, 0, 0));
  EXPECT_EQ(hand.position_W().x(), rest) << "a push below dry friction moves nothing";
}

TEST(SimulatedHand, EncodersRoundToTheirQuantum) {
  HandSettings settings;
  settings.encoder_m = 3e-5;
  SimulatedHand hand(settings, 1e-3);
  hand.start(Vec3(1e-5, 2e-5, -4.6e-5));
  EXPECT_NEAR((hand.encoded_W() - Vec3(0, 3e-5, -6e-5)).norm(), 0, 1e-18);
}

TEST(SimulatedHand, FollowsTheMotionAlongAxesThatAreNotFree) {
  HandSettings settings = exact_hand();
  settings.free_axis[2] = false;
  SimulatedHand hand(settings, 1e-3);
  hand.start(Vec3::Zero());
  hand.advance(Vec3::Zero(), Vec3(0, 0, 0.5), Vec3(0, 0, 100));
  EXPECT_EQ(hand.position_W().z(), 0.5);
}

}  // namespace
}  // namespace fingerpad::simulated_hand_test
