#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "support/plane_contact.hpp"

namespace fingerpad::stick_slip_test {
namespace {

using test::at_ticks;
using test::make_law;
using test::PlaneContact;
using test::pressed;
using test::settings_of;

constexpr double mu_s = 0.3, mu_d = 0.2, k_f = 1000;
// Forces are sums and products of a few doubles of order one.
constexpr double rounding = 1e-12;

/// A steady drag along x: the force on the finger, as its resistance, and the phase of every tick.
struct Drag {
  std::vector<double> resistance_n;
  std::vector<Phase> phase;
};
Drag drag(const FrictionLaw& law, double rate_hz, double speed, double seconds, double n = 1) {
  PlaneContact contact{law, pressed(n, rate_hz)};
  Drag result;
  for (int k = 0; k < seconds * rate_hz; ++k) {
    const Friction f = contact.move_to({speed * k / rate_hz, 0});
    result.resistance_n.push_back(-f.force_n.x());
    result.phase.push_back(f.phase);
  }
  return result;
}

TEST(StickSlip, FirstTouchAtRestSticksWithoutForce) {
  const auto law = make_law("stick-slip");
  PlaneContact contact{*law, pressed(1, 1000)};
  const Friction f = contact.move_to({0.4, -0.2});
  EXPECT_EQ(f.phase, Phase::stick);
  EXPECT_TRUE(f.centre_moved);
  EXPECT_EQ(f.force_n, Vec2(0, 0));
  EXPECT_EQ(contact.centre_m, Vec2(0.4, -0.2));
}

TEST(StickSlip, FirstTouchAboveVMinSticksUnstretchedToo) {
  const auto law = make_law("stick-slip");
  PlaneContact contact{*law, pressed(1, 1000)};
  const Friction landed = contact.move_to({0, 0}, {0.3, 0.4});
  EXPECT_EQ(landed.phase, Phase::stick);
  EXPECT_EQ(landed.force_n, Vec2(0, 0));
  // A tick later it has gone 0.5 mm: beyond its 0.3 mm, and too fast to hold again.
  const Friction f = contact.move_to({3e-4, 4e-4}, {0.3, 0.4});
  EXPECT_EQ(f.phase, Phase::slip);
  EXPECT_EQ(f.ruptures, 1);
  EXPECT_NEAR((f.force_n - Vec2(-0.12, -0.16)).norm(), 0, rounding);
}

TEST(StickSlip, SlowDragTestedAtTicksIsNearlyTheSawtoothOfThePaper) {
  const auto law = make_law("stick-slip", at_ticks());
  const double rate = 10000, speed = 0.002;
  const Drag d = drag(*law, rate, speed, 2);
  std::vector<int> ruptures;
  for (int k = 1; k < static_cast<int>(d.phase.size()); ++k) {
    if (d.phase[k] == Phase::slip && d.phase[k - 1] == Phase::stick) ruptures.push_back(k);
  }
  ASSERT_GT(ruptures.size(), 30U);
  const int first = ruptures.front(), last = ruptures.back();
  const double period_m = (last - first) * speed / rate / static_cast<double>(ruptures.size() - 1);
  double sum = 0;
  for (int k = first; k < last; ++k) sum += d.resistance_n[k];
  // A tooth is 500 ticks; one of them is slip and the rupture is seen up to a tick late: 0.4 %.
  EXPECT_NEAR(period_m, (mu_s - mu_d) / k_f, 0.01 * (mu_s - mu_d) / k_f);
  EXPECT_NEAR(sum / (last - first), 0.25, 0.01 * 0.25);
  const double peak = *std::max_element(d.resistance_n.begin(), d.resistance_n.end());
  EXPECT_LE(peak, mu_s * (1 + 1e-9));
  EXPECT_GE(peak, mu_s - k_f * speed / rate - rounding);  // at most k_f n V T below the limit
}

TEST(StickSlip, RuptureAtATickDropsTheForceFromStaticToDynamic) {
  const auto law = make_law("stick-slip", at_ticks());
  const double rate = 10000, speed = 0.002;
  const Drag d = drag(*law, rate, speed, 0.5);
  int ruptures = 0;
  for (std::size_t k = 1; k < d.phase.size(); ++k) {
    if (d.phase[k] != Phase::slip || d.phase[k - 1] != Phase::stick) continue;
    ++ruptures;
    EXPECT_NEAR(d.resistance_n[k - 1], mu_s,
                k_f * speed / rate + rounding);  // one tick's motion before the limit
    EXPECT_NEAR(d.resistance_n[k], mu_d, rounding);
  }
  EXPECT_GT(ruptures, 5);
}

TEST(StickSlip, ForceIsContinuousFromSlipToStick) {
  const auto law = make_law("stick-slip", at_ticks());
  PlaneContact contact{*law, pressed(2.5, 1000)};
  // A sine of 5 cm at 1 Hz passes 0.1 m/s four times a second.
  Friction last = contact.move_to({0, 0});
  int resticks = 0;
  for (int k = 1; k < 5000; ++k) {
    const double x = 0.05 * std::sin(2 * std::numbers::pi * k / 1000);
    const Friction f = contact.move_to({x, 0.3 * x});
    if (f.phase == Phase::stick && last.phase == Phase::slip) {
      ++resticks;
      EXPECT_NEAR((f.force_n - last.force_n).norm(), 0, rounding);
      EXPECT_NEAR(f.stretch_m.norm(), mu_d / k_f, rounding);
    }
    last = f;
  }
  EXPECT_GE(resticks, 9);
}

TEST(StickSlip, CentreIsSetBehindTheTransitionByThePapersEquation) {
  // Paper, eq. 2-3: c = a - (mu_d/k_f) v/|v|.
  const auto law = make_law("stick-slip");
  for (int i = 0; i < 24; ++i) {
    const Vec2 u = test::unit_at(0.26 * i), a(0.01, -0.02);
    PlaneContact contact{*law, pressed(0.7, 1000)};
    contact.slide_to(a, 0.11 * u);
    contact.move_to(a, 0.09 * u);
    EXPECT_NEAR((contact.centre_m - (a - mu_d / k_f * u)).norm(), 0, 1e-16);  // rounding of 1e-2 m
  }
}

TEST(StickSlip, TangentialStiffnessGrowsInProportionToTheLoad) {
  const auto law = make_law("stick-slip");
  for (const double n : {0.1, 1.0, 7.0}) {
    PlaneContact contact{*law, pressed(n, 1000)};
    contact.move_to({0, 0});
    EXPECT_NEAR(-contact.move_to({1e-4, 0}).force_n.x() / 1e-4, k_f * n, 1e-9);  // rounding of 1e4
  }
}

TEST(StickSlip, AReversalWithinATickMakesNoJump) {
  for (const Events events : {Events::tick, Events::exact}) {
    LawSettings settings;
    settings.events = events;
    const auto law = make_law("stick-slip", settings);
    PlaneContact contact{*law, pressed(1, 1000)};
    const Friction before = contact.slide_to({0, 0}, {0.2, 0});
    const Friction after = contact.move_to({0, 0}, {-0.09, 0.01});
    EXPECT_EQ(after.phase, Phase::stick);
    // Between the two velocities |(0.2 - 0.29 u, 0.01 u)| is v_min at u = 0.345, in the last tick still: the
    // stick is stretched by what that tick had left to go.
    const double u = (0.058 - std::sqrt(0.058 * 0.058 - 0.0842 * 0.03)) / 0.0842;
    const double gone_m = events == Events::exact ? (0.5 - u) * 0.0002 : 0;
    EXPECT_NEAR((after.force_n - before.force_n + Vec2(k_f * gone_m, 0)).norm(), 0, rounding);
  }
}

TEST(StickSlip, StickStartsAtTheForceAsWrittenUnderVibration) {
  const auto law = make_law("stick-slip", at_ticks());
  PlaneContact contact{*law, pressed(1, 1000)};
  const Friction slip = contact.slide_to({0, 0}, {0.2, 0});
  contact.state.slip_force_scale = 1.25;  // what touch/ multiplied that force by
  const Friction stick = contact.move_to({0.0001, 0}, {0.05, 0});
  EXPECT_EQ(stick.phase, Phase::stick);
  EXPECT_NEAR((stick.force_n - 1.25 * slip.force_n).norm(), 0, rounding);
  const Friction held = contact.move_to({0.0001, 0}, {0, 0});
  EXPECT_NEAR((held.force_n - stick.force_n).norm(), 0, rounding);
}

TEST(StickSlip, BetweenTicksStickStartsAtTheForceAsWrittenAndIsStretchedByWhatIsLeftOfTheTick) {
  const auto law = make_law("stick-slip");
  PlaneContact contact{*law, pressed(1, 1000)};
  contact.slide_to({0, 0}, {0.2, 0});
  contact.state.slip_force_scale = 1.25;
  // From 0.2 m/s in the middle of the last tick to 0.05 in the middle of this one: 0.1 after a sixth of it.
  const Friction stick = contact.move_to({0.00005, 0}, {0.05, 0});
  EXPECT_EQ(stick.phase, Phase::stick);
  EXPECT_NEAR(stick.force_n.x(), -(1.25 * mu_d + k_f * 0.00005 * 5 / 6), rounding);
}

TEST(StickSlip, ASpringThatWouldStartRupturedWaits) {
  for (const Events events : {Events::tick, Events::exact}) {
    LawSettings settings;
    settings.events = events;
    const auto law = make_law("stick-slip", settings);
    PlaneContact contact{*law, pressed(1, 1000)};
    contact.slide_to({0, 0}, {0.2, 0});
    contact.state.slip_force_scale = 1.6;  // 0.32 n, above the static limit
    EXPECT_EQ(contact.move_to({0.00005, 0}, {0.05, 0}).phase, Phase::slip);
    EXPECT_EQ(contact.move_to({0.0001, 0}, {0.05, 0}).phase, Phase::stick);
  }
}

TEST(StickSlip, UnloadingAloneNeverSlips) {
  const auto law = make_law("stick-slip");
  PlaneContact contact{*law, pressed(3, 1000)};
  contact.move_to({0, 0});
  contact.move_to({0.00029, 0});
  for (int k = 0; k <= 3000; ++k) {
    contact.motion.normal_force_n = 3 - k * 1e-3;
    EXPECT_EQ(contact.move_to({0.00029, 0}).phase, Phase::stick);
  }
}

TEST(StickSlip, AtRestTheCentreNeverMoves) {
  const auto law = make_law("stick-slip");
  PlaneContact contact{*law, pressed(1, 1000)};
  contact.slide_to({0.1, 0.1}, {0.5, 0.1});
  const Friction first = contact.move_to({0.10001, 0.1}, {0.01, 0});
  ASSERT_EQ(first.phase, Phase::stick);
  const Vec2 centre = contact.centre_m;
  for (int k = 0; k < 10000; ++k) {
    const Friction f = contact.move_to({0.10001, 0.1});
    ASSERT_EQ(contact.centre_m, centre);
    ASSERT_FALSE(f.centre_moved);
    // S minus the centre is rounded at 1e-17 m, times k_f n.
    ASSERT_NEAR((f.force_n - first.force_n).norm(), 0, 1e-13);
  }
}

TEST(StickSlip, EqualCoefficientsStickOnTheLimit) {
  const auto law = make_law("stick-slip");
  PlaneContact contact{*law, pressed(1, 1000)};
  contact.motion.mu_dynamic = contact.motion.mu_static;
  contact.slide_to({0.001, 0}, {0.7, 0.3});
  for (int k = 0; k < 100; ++k) EXPECT_EQ(contact.move_to({0.001, 0}, {0, 0}).phase, Phase::stick);
}

TEST(StickSlip, CrossingSlipsOnAfterASlowRupture) {
  LawSettings settings;
  settings.restick = Restick::crossing;
  const auto law = make_law("stick-slip", settings);
  const Drag d = drag(*law, 10000, 0.002, 1);
  const auto rupture = std::find(d.phase.begin(), d.phase.end(), Phase::slip);
  ASSERT_NE(rupture, d.phase.end());
  EXPECT_EQ(std::find(rupture, d.phase.end(), Phase::stick), d.phase.end());
}

TEST(StickSlip, CrossingAtRestKeepsTheLastSlipDirection) {
  LawSettings settings;
  settings.restick = Restick::crossing;
  const auto law = make_law("stick-slip", settings);
  PlaneContact contact{*law, pressed(1, 1000)};
  contact.move_to({0, 0});
  contact.move_to({0.0004, 0}, {0.01, 0});
  const Friction f = contact.move_to({0.0004, 0}, {0, 0});
  EXPECT_EQ(f.phase, Phase::slip);
  EXPECT_NEAR((f.force_n - Vec2(-mu_d, 0)).norm(), 0, rounding);
}

TEST(StickSlip, CrossingSticksWhereTheSpeedFallsThroughVMin) {
  LawSettings settings;
  settings.restick = Restick::crossing;
  const auto law = make_law("stick-slip", settings);
  PlaneContact contact{*law, pressed(1, 1000)};
  EXPECT_EQ(contact.slide_to({0, 0}, {0.2, 0}).phase, Phase::slip);
  // The middle of this tick is at v_min: stick begins there.
  const Friction f = contact.move_to({0.0001, 0}, {0.1, 0});
  EXPECT_EQ(f.phase, Phase::stick);
  EXPECT_NEAR(f.force_n.x(), -(mu_d + k_f * 0.00005), rounding);
}

TEST(StickSlip, ThePaperFigure12RunStaysUnderTheStaticLimit) {
  const auto law = make_law("stick-slip", settings_of({{"stick_stiffness_per_m", 200}}));
  PlaneContact contact{*law, pressed(1, 500)};
  for (int k = 0; k < 5000; ++k) {
    const double t = k / 500.0;
    contact.motion.normal_force_n = 2 + std::sin(3 * t);
    const Friction f = contact.move_to({0.04 * std::sin(6 * t), 0});
    const double mu = f.force_n.norm() / contact.motion.normal_force_n;
    ASSERT_LE(mu, mu_s * (1 + 1e-9));
    if (f.phase == Phase::slip) {
      ASSERT_NEAR(mu, mu_d, 1e-9);
    }
  }
}

}  // namespace
}  // namespace fingerpad::stick_slip_test
