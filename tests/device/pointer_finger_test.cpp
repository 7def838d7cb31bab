#include "device/pointer_finger.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace fingerpad::pointer_finger_test {
namespace {

const FingerSample origin{0, Vec3::Zero(), Vec3::UnitY()};
const FingerSample there{0, Vec3(0.1, 0, 0), Vec3::UnitZ()};

TEST(PointerFinger, ArrivesWithoutOvershoot) {
  PointerFinger finger(origin, 8);
  finger.set_target(there);
  double last = 0;
  for (int k = 0; k < 1000; ++k) {
    const FingerSample sample = finger.advance(1e-3);
    ASSERT_GE(sample.p_WQ.x(), last - 1e-15);
    ASSERT_LE(sample.p_WQ.x(), 0.1 + 1e-15);
    ASSERT_NEAR(sample.direction_W.norm(), 1, 1e-12);
    last = sample.p_WQ.x();
  }
  EXPECT_NEAR(last, 0.1, 1e-9);
}

TEST(PointerFinger, GoesTheSameWayAtAnyRate) {
  PointerFinger coarse(origin, 8), fine(origin, 8);
  coarse.set_target(there);
  fine.set_target(there);
  const double x_coarse = coarse.advance(0.04).p_WQ.x();
  double x_fine = 0;
  for (int k = 0; k < 40; ++k) x_fine = fine.advance(1e-3).p_WQ.x();
  EXPECT_NEAR(x_coarse, x_fine, 1e-15);  // the closed form: only rounding differs
}

TEST(PointerFinger, StaysWhereNothingPullsIt) {
  PointerFinger finger(origin, 8);
  for (int k = 0; k < 100; ++k) EXPECT_EQ(finger.advance(1e-3).p_WQ, Vec3::Zero());
}

}  // namespace
}  // namespace fingerpad::pointer_finger_test
