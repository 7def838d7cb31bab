#include "friction/contact_area.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/plane_contact.hpp"

namespace fingerpad::contact_area_test {
namespace {

using test::make_law;

constexpr double rounding = 1e-12;

double slip_force_n(const FrictionLaw& law, double n) {
  test::PlaneContact contact{law, test::pressed(n, 1000)};
  const Friction f = contact.slide_to({0, 0}, {0.2, 0});
  EXPECT_EQ(f.phase, Phase::slip);
  return f.force_n.norm();
}

TEST(ContactArea, LimitGoesWithTheTwoThirdsPowerOfTheLoad) {
  const auto law = make_law("contact-area");
  for (const double n : {1e-3, 0.1, 1.0, 7.0}) {
    EXPECT_NEAR(slip_force_n(*law, n), 0.2 * std::pow(n, 2.0 / 3), rounding) << n;
  }
}

TEST(ContactArea, AdhesionLeavesJkrsLimitWithoutLoad) {
  const double radius = 0.008, gamma = 0.5;
  const auto law =
      make_law("contact-area", test::settings_of({{"pad_radius_m", radius}, {"adhesion_j_per_m2", gamma}}));
  const double w = 3 * std::numbers::pi * gamma * radius;
  // a^3 at n = 0 is 2 w R/K; tau is set at 1 N.
  const double area_ratio = std::pow(2 * w / (1 + w + std::sqrt(2 * w + w * w)), 2.0 / 3);
  EXPECT_NEAR(slip_force_n(*law, 0), 0.2 * area_ratio, rounding);
  EXPECT_NEAR(slip_force_n(*law, 1e-12), 0.2 * area_ratio, 1e-6);  // the root of 2 w n is 3e-7 here
  EXPECT_NEAR(slip_force_n(*law, 1), 0.2, rounding);
}

TEST(JkrPad, WithoutAdhesionIsHertz) {
  const JkrPad pad{0.008, 1e5, 0};
  for (const double n : {0.01, 1.0, 4.0}) {
    EXPECT_NEAR(pad.contact_radius_m(n), std::cbrt(n * 0.008 * 3 / (4 * 1e5)), 1e-15);
  }
  EXPECT_EQ(pad.pull_off_n(), 0);
}

TEST(JkrPad, PartsAtThePullOffTension) {
  const JkrPad pad{0.008, 1e5, 0.05};
  const double pull_off = 1.5 * std::numbers::pi * 0.05 * 0.008;
  EXPECT_NEAR(pad.pull_off_n(), pull_off, 1e-15);
  // There the radius is 0.63 of that at no load: a^3 falls from 2 w to w/2.
  EXPECT_NEAR(pad.contact_radius_m(-pull_off) / pad.contact_radius_m(0), std::cbrt(0.25), 1e-6);
}

}  // namespace
}  // namespace fingerpad::contact_area_test
