#include "device/follower.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace fingerpad::follower_test {
namespace {

const Vec3 there_m(0.1, 0, 0);

TEST(Follower, ArrivesWithoutOvershoot) {
  Follower finger(Vec3::Zero(), 8);
  double last = 0;
  for (int k = 0; k < 1000; ++k) {
    const double x_m = finger.advance(there_m, 1e-3).x();
    ASSERT_GE(x_m, last - 1e-15);
    ASSERT_LE(x_m, 0.1 + 1e-15);
    last = x_m;
  }
  EXPECT_NEAR(last, 0.1, 1e-9);
}

TEST(Follower, GoesTheSameWayAtAnyRate) {
  Follower coarse(Vec3::Zero(), 8), fine(Vec3::Zero(), 8);
  const double x_coarse = coarse.advance(there_m, 0.04).x();
  double x_fine = 0;
  for (int k = 0; k < 40; ++k) x_fine = fine.advance(there_m, 1e-3).x();
  EXPECT_NEAR(x_coarse, x_fine, 1e-15);  // the closed form: only rounding differs
}

TEST(Follower, StaysWhereNothingPullsIt) {
  Follower finger(Vec3::Zero(), 8);
  for (int k = 0; k < 100; ++k) EXPECT_EQ(finger.advance(Vec3::Zero(), 1e-3), Vec3::Zero());
}

}  // namespace
}  // namespace fingerpad::follower_test
