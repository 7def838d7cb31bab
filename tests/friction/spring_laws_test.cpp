#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/plane_contact.hpp"

namespace fingerpad::spring_laws_test {
namespace {

using test::make_law;
using test::PlaneContact;
using test::pressed;
using test::settings_of;

constexpr double mu_s = 0.3, mu_d = 0.2;
constexpr double rounding = 1e-12;

/// Whether a law that is stretched at 3 N to nine tenths of its limit slips when the load is taken off.
bool slips_by_unloading(const FrictionLaw& law, double share_of_limit_m) {
  PlaneContact contact{law, pressed(3, 1000)};
  contact.move_to({0, 0});
  for (int k = 1; k <= 1000; ++k) contact.move_to({share_of_limit_m * k / 1000, 0});
  bool slipped = false;
  Vec2 force = Vec2::Zero();
  for (int k = 0; k <= 1000; ++k) {
    contact.motion.normal_force_n = 3 - 2.9 * k / 1000;
    const Friction f = contact.move_to({share_of_limit_m, 0});
    slipped = slipped || f.ruptures > 0;
    force = f.force_n;
  }
  // A bristle shortens with its limit and then rests there: what counts is that the way back has been lost.
  const Friction back = contact.move_to({0, 0});
  return slipped || back.force_n.x() > 1e-6;
}

TEST(SpringLaws, FixedStiffnessSlipsByUnloadingAndThePapersDoesNot) {
  for (const char* name : {"salisbury", "salcudean-vlaar", "friction-cone"}) {
    EXPECT_TRUE(slips_by_unloading(*make_law(name), 0.9 * mu_s * 3 / 1000)) << name;
  }
  for (const char* name : {"dahl", "kikuuwe"}) {
    EXPECT_TRUE(slips_by_unloading(*make_law(name), 0.9 * mu_d * 3 / 1000)) << name;
  }
  for (const char* name : {"stick-slip", "finger-pad", "contact-area"}) {
    EXPECT_FALSE(slips_by_unloading(*make_law(name), 0.7 * mu_s / 1000)) << name;
  }
  EXPECT_FALSE(slips_by_unloading(*make_law("max-displacement"), 0.9 * mu_d / 1000));
}

TEST(Salisbury, BetweenTicksIsTheExactSawtoothAtEverySpeed) {
  const auto law = make_law("salisbury");
  for (const double speed : {0.002, 0.2, 7.0}) {
    PlaneContact contact{*law, pressed(1, 1000)};
    for (int k = 0; k < 5000; ++k) {
      const double pull = speed * k;  // the spring's 1000 N/m times the way
      const double tooth = mu_s - mu_d, expected = pull < mu_s ? pull : mu_d + std::fmod(pull - mu_s, tooth);
      const double f = -contact.move_to({speed * k / 1000, 0}).force_n.x();
      // At a tooth's end rounding decides on which side of the jump a tick lies.
      const double off = std::abs(f - expected);
      ASSERT_LT(std::min(off, std::abs(off - tooth)), 1e-8) << speed << " " << k;
    }
  }
}

TEST(Salisbury, AtTicksIsASawtoothAtEverySpeed) {
  const auto law = make_law("salisbury", test::at_ticks());
  const double rate = 20000;
  for (const double speed : {0.002, 0.2}) {
    PlaneContact contact{*law, pressed(1, rate)};
    double sum = 0, least = 1, most = 0;
    const int ticks = 200000;
    for (int k = 0; k < 2 * ticks; ++k) {
      const double f = -contact.move_to({speed * k / rate, 0}).force_n.x();
      if (k < ticks) continue;
      sum += f;
      least = std::min(least, f);
      most = std::max(most, f);
    }
    // A tick moves K V T = 0.01 N of a tooth of 0.1 N at the higher speed: so far is a peak or the mean off
    // at most.
    const double tick_n = 1000 * speed / rate;
    EXPECT_NEAR(sum / ticks, 0.25, tick_n);
    EXPECT_NEAR(least, mu_d, rounding);
    EXPECT_LE(most, mu_s * (1 + 1e-9));
    EXPECT_GE(most, mu_s - tick_n - rounding);
  }
}

TEST(SalcudeanVlaar, SlipIsViscousAndAgreesWithTheOthersAtVMin) {
  const auto law = make_law("salcudean-vlaar");
  PlaneContact contact{*law, pressed(2, 1000)};
  EXPECT_NEAR(contact.slide_to({0, 0}, {0.3, 0}).force_n.x(), -mu_d * 2 * 3, rounding);
  EXPECT_NEAR(contact.slide_to({0, 0}, {0.1001, 0}).force_n.x(), -mu_d * 2 * 1.001, rounding);
  const auto published = make_law("salcudean-vlaar", settings_of({{"slip_damping_n_s_per_m", 5}}));
  PlaneContact other{*published, pressed(2, 1000)};
  EXPECT_NEAR(other.slide_to({0, 0}, {0.3, 0}).force_n.x(), -1.5, rounding);
}

TEST(SalcudeanVlaar, ForceIsContinuousFromSlipToStick) {
  const auto law = make_law("salcudean-vlaar", test::at_ticks());
  PlaneContact contact{*law, pressed(1, 1000)};
  contact.slide_to({0, 0}, {0.1001, 0});
  const Friction stick = contact.move_to({1e-4, 0}, {0.0999, 0});
  EXPECT_EQ(stick.phase, Phase::stick);
  EXPECT_NEAR(stick.force_n.x(), -mu_d * 0.999, rounding);
  EXPECT_NEAR((contact.move_to({1e-4, 0}, {0, 0}).force_n - stick.force_n).norm(), 0, rounding);
}

TEST(Karnopp, AnswersTheAppliedForceUpToTheStaticLimit) {
  const auto law = make_law("karnopp");
  PlaneContact contact{*law, pressed(2, 1000)};
  contact.motion.applied_force_n = {0.3, 0.4};
  const Friction held = contact.move_to({0, 0}, {0, 0});
  EXPECT_EQ(held.phase, Phase::stick);
  EXPECT_EQ(held.force_n, Vec2(-0.3, -0.4));
  contact.motion.applied_force_n = {3, 4};
  const Friction broken = contact.move_to({0, 0}, {0, 0});
  EXPECT_EQ(broken.phase, Phase::slip);
  EXPECT_NEAR((broken.force_n - mu_s * 2 * Vec2(-0.6, -0.8)).norm(), 0, rounding);
  const Friction slip = contact.move_to({0, 0}, {0.0011, 0});
  EXPECT_NEAR((slip.force_n - Vec2(-0.4, 0)).norm(), 0, rounding);
}

TEST(Karnopp, WithoutAHandItsBandHasNoForce) {
  const auto law = make_law("karnopp");
  PlaneContact contact{*law, pressed(2, 1000)};
  EXPECT_EQ(contact.move_to({0, 0}, {0.0009, 0}).force_n, Vec2(0, 0));
}

TEST(FrictionCone, HoldsToTheStaticConeThenSlidesOnTheDynamicOne) {
  const auto law = make_law("friction-cone");
  PlaneContact contact{*law, pressed(2, 1000)};
  contact.motion.surface_stiffness_n_per_m = 500;
  const double depth = 2.0 / 500, step = 1e-6;
  contact.move_to({0, 0});
  double x = 0;
  while (contact.move_to({x + step, 0}).phase == Phase::stick) x += step;
  EXPECT_NEAR(x, mu_s * depth, step);
  // It stays on the dynamic rim however slowly it is drawn, and holds again when drawn back.
  for (int k = 2; k < 100; ++k) {
    const Friction f = contact.move_to({x + step * k, 0});
    EXPECT_EQ(f.phase, Phase::slip);
    EXPECT_NEAR(f.force_n.x(), -mu_d * 2, rounding);
  }
  const Friction back = contact.move_to({x + step * 98, 0});
  EXPECT_EQ(back.phase, Phase::stick);
  EXPECT_NEAR(back.force_n.x(), -mu_d * 2 + 500 * step, rounding);
}

TEST(Kikuuwe, IsAHardSpringThatSaturates) {
  const auto law = make_law("kikuuwe");
  PlaneContact contact{*law, pressed(1, 1000)};
  contact.move_to({0, 0});
  EXPECT_NEAR(contact.move_to({1e-4, 0}).force_n.x(), -0.1, rounding);
  const Friction sliding = contact.move_to({5e-4, 0});
  EXPECT_EQ(sliding.phase, Phase::slip);
  EXPECT_NEAR(sliding.force_n.x(), -mu_d, rounding);
  EXPECT_NEAR(contact.move_to({4e-4, 0}).force_n.x(), -mu_d + 0.1, rounding);
}

TEST(Kikuuwe, DamperAddsItsForceInStick) {
  const auto law = make_law("kikuuwe", settings_of({{"stick_damping_n_s_per_m", 2}}));
  PlaneContact contact{*law, pressed(1, 1000)};
  contact.move_to({0, 0});
  const double dx = 1e-5;
  EXPECT_NEAR(contact.move_to({dx, 0}).force_n.x(), -(1000 * dx + 2 * dx * 1000), rounding);
  // At rest the damper is silent and the spring keeps its stretch.
  for (int k = 0; k < 5; ++k) EXPECT_NEAR(contact.move_to({dx, 0}).force_n.x(), -1000 * dx, rounding);
}

}  // namespace
}  // namespace fingerpad::spring_laws_test
