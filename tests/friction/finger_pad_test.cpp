#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/plane_contact.hpp"

namespace fingerpad::finger_pad_test {
namespace {

using test::make_law;
using test::PlaneContact;
using test::pressed;
using test::settings_of;
using test::unit_at;

constexpr double deg = std::numbers::pi / 180;
constexpr double mu_s = 0.3, mu_d = 0.2;
constexpr double rounding = 1e-12;  // forces are a few products of numbers of order one

/// How far from the centre the pad lets go when it is drawn slowly along a direction of frame C.
double breakaway_m(const FrictionLaw& law, const TangentialMotion& motion, const Vec2& direction,
                   double step_m) {
  PlaneContact contact{law, motion};
  contact.move_to({0, 0});
  for (int k = 1; k < 100000; ++k) {
    const Friction f = contact.move_to(direction * (k * step_m));
    if (f.ruptures > 0) return k * step_m;
  }
  return std::nan("");
}

TEST(FingerPad, BreaksAwayOnTheEllipseInEveryDirectionAtEveryAngle) {
  const auto law = make_law("finger-pad");
  const double step_m = 2e-7;  // 0.1 % of the axes: the limit of what one tick can tell
  for (const double angle_deg : {0.0, 20.0, 45.0, 70.0, 90.0}) {
    const PadProfile pad = assumed_profile(mu_s, 1000);
    const double a = pad.lateral_axis_at(angle_deg * deg), b = pad.longitudinal_axis_at(angle_deg * deg);
    for (int i = 0; i < 24; ++i) {
      const double theta = 15 * deg * i;  // from the lateral axis
      TangentialMotion motion = pressed(1, 1000);
      motion.inclination_rad = angle_deg * deg;
      const double radius = a * b / std::hypot(b * std::cos(theta), a * std::sin(theta));
      const double measured = breakaway_m(*law, motion, unit_at(theta), step_m);
      EXPECT_GE(measured, radius * (1 - 1e-9)) << angle_deg << " deg, direction " << 15 * i;
      EXPECT_LE(measured, radius + step_m * (1 + 1e-9)) << angle_deg << " deg, direction " << 15 * i;
    }
  }
}

TEST(FingerPad, EllipseTurnsWithTheFinger) {
  const auto law = make_law("finger-pad");
  const double a = mu_s / 1000, b = 0.8 * a, step_m = 2e-7;
  for (const double turn : {0.3, 1.2, 2.5, -2.0}) {
    TangentialMotion motion = pressed(1, 1000);
    motion.inclination_rad = 45 * deg;
    motion.longitudinal = unit_at(turn);
    EXPECT_NEAR(breakaway_m(*law, motion, unit_at(turn), step_m), b, step_m * (1 + 1e-9));
    EXPECT_NEAR(breakaway_m(*law, motion, unit_at(turn - 90 * deg), step_m), a, step_m * (1 + 1e-9));
  }
}

TEST(FingerPad, LimitForceIsTheSameInEveryDirection) {
  const auto law = make_law("finger-pad");
  for (int i = 0; i < 24; ++i) {
    PlaneContact contact{*law, pressed(1, 1000)};
    contact.motion.inclination_rad = 70 * deg;
    contact.move_to({0, 0});
    double peak = 0;
    for (int k = 1; k < 4000; ++k) {
      const Friction f = contact.move_to(unit_at(15 * deg * i) * (k * 1e-7));
      if (f.ruptures > 0) break;
      peak = f.force_n.norm();
    }
    EXPECT_LE(peak, mu_s * (1 + 1e-9));
    EXPECT_GE(peak, mu_s * (1 - 1e-3));  // one step of 1e-7 m on an axis of 1.8e-4 m
  }
}

TEST(FingerPad, AxesScaleWithThePartsFriction) {
  LawSettings settings;
  settings.profile = assumed_profile(0.3, 1000);
  const auto law = make_law("finger-pad", settings);
  TangentialMotion motion = pressed(1, 1000);
  motion.inclination_rad = 45 * deg;
  motion.mu_static = 0.9;
  EXPECT_NEAR(breakaway_m(*law, motion, {1, 0}, 1e-7), 0.9e-3, 1e-7 * (1 + 1e-9));
  motion.mu_static = 0.3;
  EXPECT_NEAR(breakaway_m(*law, motion, {1, 0}, 1e-7), 0.3e-3, 1e-7 * (1 + 1e-9));
}

TEST(FingerPad, ProfileReplacesTheStickStiffness) {
  LawSettings settings = settings_of({{"stick_stiffness_per_m", 5}});
  PadProfile pad;
  pad.lateral_axis_m = 2e-3;
  pad.longitudinal_axis_m = 1e-3;
  pad.mu_static = 0.6;
  settings.profile = pad;
  const auto law = make_law("finger-pad", settings);
  TangentialMotion motion = pressed(1, 1000);
  motion.inclination_rad = 45 * deg;
  EXPECT_NEAR(breakaway_m(*law, motion, {1, 0}, 1e-6), 1e-3, 1e-6 * (1 + 1e-9));
  EXPECT_NEAR(breakaway_m(*law, motion, {0, 1}, 1e-6), 0.5e-3, 1e-6 * (1 + 1e-9));
}

TEST(FingerPad, SceneKeyOverrulesTheProfilesVMin) {
  LawSettings settings;
  settings.profile = assumed_profile(0.3, 1000);
  settings.profile->v_min_m_per_s = 0.02;
  const auto by_profile = make_law("finger-pad", settings);
  settings.numbers["v_min_m_per_s"] = 0.3;
  const auto by_key = make_law("finger-pad", settings);
  // 0.05 m/s over 2 mm: beyond the profile's v_min it slides on, below the key's it holds again at once.
  PlaneContact a{*by_profile, pressed(1, 1000)}, b{*by_key, pressed(1, 1000)};
  EXPECT_EQ(a.slide_to({0, 0}, {0.05, 0}).phase, Phase::slip);
  EXPECT_EQ(b.slide_to({0, 0}, {0.05, 0}).phase, Phase::stick);
}

TEST(FingerPad, TiltAloneBreaksTheStickInTheDirectionOfTheSpring) {
  const auto law = make_law("finger-pad");
  PlaneContact contact{*law, pressed(1, 1000)};
  contact.motion.inclination_rad = 20 * deg;
  const Vec2 pull = Vec2(1, 2).normalized() * 2e-4;
  contact.move_to({0, 0});
  const Friction held = contact.move_to(pull);
  ASSERT_EQ(held.phase, Phase::stick);
  Friction f = held, last = held;
  for (int k = 0; k <= 70 && f.ruptures == 0; ++k) {
    last = f;
    contact.motion.inclination_rad = (20 + k) * deg;
    f = contact.move_to(pull);
  }
  ASSERT_EQ(f.ruptures, 1);
  EXPECT_NEAR(f.force_n.norm(), mu_d, rounding);
  // The spring's own direction turns a little over the last degree of tilt.
  EXPECT_GT(f.force_n.normalized().dot(last.force_n.normalized()), 1 - 1e-4);
}

TEST(FingerPad, ForceIsContinuousFromSlipToStickInEveryDirection) {
  for (const double cubic : {0.0, 0.4, 1.0}) {
    const auto law = make_law("finger-pad", settings_of({{"cubic_share", cubic}}));
    for (int i = 0; i < 24; ++i) {
      PlaneContact contact{*law, pressed(1, 1000)};
      contact.motion.inclination_rad = 20 * deg;
      contact.motion.normal_force_n = 1.7;
      const Vec2 u = unit_at(15 * deg * i);
      const Friction slip = contact.slide_to({0, 0}, u * 0.2);
      const Friction stick = contact.move_to({0, 0}, u * 0.09);
      const Friction held = contact.move_to({0, 0}, {0, 0});
      EXPECT_NEAR((stick.force_n - slip.force_n).norm(), 0, rounding);
      EXPECT_NEAR((held.force_n - slip.force_n).norm(), 0, rounding) << "cubic " << cubic;
    }
  }
}

TEST(FingerPad, ThirdOrderSpringMeetsTheLinearOneAtTheLimit) {
  const auto law = make_law("finger-pad", settings_of({{"cubic_share", 0.5}}));
  PlaneContact contact{*law, pressed(1, 1000)};
  contact.motion.inclination_rad = 45 * deg;
  contact.move_to({0, 0});
  for (const double rho : {0.1, 0.5, 0.9, 1.0}) {
    const Friction f = contact.move_to({rho * mu_s / 1000, 0});
    EXPECT_EQ(f.phase, Phase::stick);
    EXPECT_NEAR(-f.force_n.x(), mu_s * rho * (0.5 + 0.5 * rho * rho), rounding);
  }
  EXPECT_EQ(contact.move_to({1.001 * mu_s / 1000, 0}).ruptures, 1);
}

TEST(FingerPad, FrictionRisesBelowTwoNewtonsAndNeverSlipsByLoadAlone) {
  const auto law = make_law("finger-pad", settings_of({{"mu_rises_below_n", 2}}));
  for (const double n : {0.01, 0.1, 1.0, 2.0, 5.0}) {
    PlaneContact sliding{*law, pressed(n, 1000)};
    const double mu = sliding.slide_to({0, 0}, {0.2, 0}).force_n.norm() / n;
    EXPECT_NEAR(mu, mu_d * std::max(1.0, std::pow(n / 2, -1.0 / 3)), 1e-12);
  }
  PlaneContact contact{*law, pressed(1, 1000)};
  contact.motion.inclination_rad = 45 * deg;
  contact.move_to({0, 0});
  for (int k = 0; k <= 4000; ++k) {
    contact.motion.normal_force_n = 2 + 2 * std::cos(k * 0.01);
    ASSERT_EQ(contact.move_to({0.00029, 0}).phase, Phase::stick);
  }
}

TEST(FingerPad, WithoutStaticFrictionNothingIsDividedByZero) {
  const auto law = make_law("finger-pad", settings_of({{"cubic_share", 0.5}}));
  PlaneContact contact{*law, pressed(1, 1000)};
  contact.motion.mu_static = contact.motion.mu_dynamic = 0;
  for (int k = 0; k < 200; ++k) {
    const Friction f = contact.move_to({k * 1e-4 * (k % 3), 0});
    EXPECT_EQ(f.force_n, Vec2(0, 0));
    EXPECT_TRUE(f.stretch_m.allFinite());
  }
}

}  // namespace
}  // namespace fingerpad::finger_pad_test
