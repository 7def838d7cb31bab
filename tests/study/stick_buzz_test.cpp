#include "study/stick_buzz.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace fingerpad::stick_buzz_test {
namespace {

// The hand's own spring of 20 N/m and the bisection's 0.5 % stand beside the rule k_f n < 2 b/T.
constexpr double tolerance = 0.03;

TEST(StickBuzz, ThePapersStickBuzzesAboveOneNewtonAtAKilohertz) {
  EXPECT_NEAR(quiet_load_n({}), 1, tolerance);  // SCIENCE 4: k_f = 1000 1/m, b = 0.5 N s/m
  EXPECT_NEAR(quiet_load_n({.rate_hz = 250}), 0.25, tolerance * 0.25);
}

TEST(StickBuzz, ThePadsShortAxisBuzzesSooner) {
  StuckFinger finger{.law = "finger-pad", .push_along_finger = true};
  EXPECT_NEAR(quiet_load_n(finger), 0.8, tolerance * 0.8);  // SCIENCE 4, at 45 deg
  finger.inclination_rad = 89.9 * std::numbers::pi / 180;
  EXPECT_NEAR(quiet_load_n(finger), 0.44, tolerance * 0.44);  // and at 90 deg
}

TEST(StickBuzz, AFixedStiffnessBuzzesAtEveryLoadOrAtNone) {
  for (const char* law : {"salisbury", "dahl", "kikuuwe", "friction-cone"}) {
    EXPECT_EQ(quiet_load_n({.law = law, .rate_hz = 500}), 0) << law;  // 1000 N/m against 2 b/T = 500
    EXPECT_TRUE(std::isinf(quiet_load_n({.law = law, .rate_hz = 2000}))) << law;
  }
}

TEST(StickBuzz, EveryRemedyKeepsAStickQuietThatBuzzesWithoutIt) {
  for (const Remedy remedy : {Remedy::damping, Remedy::implicit, Remedy::cap}) {
    StuckFinger finger;
    finger.settings.remedy = remedy;
    EXPECT_GT(quiet_load_n(finger), 10) << static_cast<int>(remedy);  // 1 N without
  }
}

}  // namespace
}  // namespace fingerpad::stick_buzz_test
