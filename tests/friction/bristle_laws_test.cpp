#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/sliding_mass.hpp"

namespace fingerpad::bristle_laws_test {
namespace {

using test::make_law;
using test::PlaneContact;
using test::pressed;
using test::settings_of;
using test::SlidingMass;

constexpr double mu_s = 0.3, mu_d = 0.2;
constexpr double rounding = 1e-12;

/// Canudas de Wit 1995: sigma0 = 1e5, sigma1 = sqrt(1e5), sigma2 = 0.4, v_s = 1e-3; with F_c = 1, F_s = 1.5
/// at 1 N.
LawSettings canudas() {
  return settings_of({{"stick_stiffness_n_per_m", 1e5},
                      {"bristle_damping_n_s_per_m", std::sqrt(1e5)},
                      {"viscous_n_s_per_m", 0.4},
                      {"stribeck_speed_m_per_s", 1e-3}});
}
TangentialMotion canudas_load(double rate_hz) {
  TangentialMotion motion = pressed(1, rate_hz);
  motion.mu_static = 1.5;
  motion.mu_dynamic = 1;
  return motion;
}

TEST(Dahl, OnALineIsTheExponentialWhateverTheStep) {
  const auto law = make_law("dahl");
  for (const int steps : {1, 7, 1000}) {
    PlaneContact contact{*law, pressed(1, 1000)};
    contact.move_to({0, 0});
    Friction f;
    for (int k = 1; k <= steps; ++k) f = contact.move_to({3e-4 * k / steps, 0});
    EXPECT_NEAR(-f.force_n.x(), mu_d * (1 - std::exp(-3e-4 / 2e-4)), rounding);
  }
}

/// By how much -force lags behind the velocity on a circle, and |force|, after three rounds.
struct Lag {
  double angle_rad, force_n;
};
Lag circle_lag(const FrictionLaw& law, double radius_m) {
  const int per_round = 20000;
  PlaneContact contact{law, pressed(1, 10000)};
  Friction f;
  double angle = 0;
  for (int k = 0; k <= 3 * per_round; ++k) {
    angle = 2 * std::numbers::pi * k / per_round;
    f = contact.move_to(radius_m * test::unit_at(angle));
  }
  const Vec2 v(-std::sin(angle), std::cos(angle)), resistance = -f.force_n;
  return {std::atan2(resistance.x() * v.y() - resistance.y() * v.x(), resistance.dot(v)), resistance.norm()};
}

TEST(Dahl, OnACircleLagsByItsClosedForm) {
  const auto law = make_law("dahl");
  const double z_c = 2e-4;
  for (const double radius : {1e-4, 5e-4, 5e-3}) {
    const Lag lag = circle_lag(*law, radius);
    // A step turns by 2 pi/20000 = 3e-4 rad, and is taken as straight.
    EXPECT_NEAR(lag.angle_rad, std::atan(z_c / radius), 3e-4) << radius;
    EXPECT_NEAR(lag.force_n, mu_d / std::sqrt(1 + std::pow(z_c / radius, 2)), 1e-4) << radius;
  }
}

TEST(MaxDisplacement, OnACircleLagsByItsClosedForm) {
  const auto law = make_law("max-displacement");
  for (const double radius : {4e-4, 5e-3}) {
    const Lag lag = circle_lag(*law, radius);
    EXPECT_NEAR(lag.angle_rad, std::asin(2e-4 / radius), 3e-4) << radius;  // as above
    EXPECT_NEAR(lag.force_n, mu_d, rounding);
  }
}

TEST(MaxDisplacement, SmoothFormYieldsBeforeItsLimitAndSlidesAtIt) {
  const auto law = make_law("max-displacement", settings_of({{"stick_displacement_m", 1.5e-4}}));
  PlaneContact contact{*law, pressed(1, 1000)};
  contact.move_to({0, 0});
  Friction f;
  for (int k = 1; k <= 20; ++k) f = contact.move_to({1e-5 * k, 0});
  EXPECT_LT(-f.force_n.x(), mu_d * 0.99);  // the hard form stands at mu_d here
  for (int k = 21; k <= 500; ++k) f = contact.move_to({1e-5 * k, 0});
  EXPECT_NEAR(-f.force_n.x(), mu_d, rounding);
}

TEST(LuGre, SteadySlidingFollowsTheStribeckCurve) {
  const auto law = make_law("lugre");
  for (const double speed : {0.001, 0.005, 0.01, 0.02, 0.3}) {
    PlaneContact contact{*law, pressed(1, 1000)};
    Friction f;
    const double step = speed / 1000;
    for (int k = 0; k * step < 0.01; ++k) f = contact.move_to({k * step, 0});  // 30 bristle lengths
    EXPECT_NEAR(-f.force_n.x(), mu_d + 0.1 * std::exp(-std::pow(speed / 0.01, 2)), 1e-9) << speed;
  }
}

TEST(LuGre, PreslidingRampFollowsTheClosedForm) {
  // The paper's ramp: 0.1425 N/s up to 1.425 N. Slower than v_s all the way, so g = F_s and x = -z_c ln(1 -
  // F/F_s).
  const auto law = make_law("lugre", canudas());
  SlidingMass mass{{*law, canudas_load(10000)}};
  const auto ramp = [](double, double t) { return std::min(1.425, 0.1425 * t); };
  while (mass.t_s < 10) mass.tick(ramp);
  const double expected = -1.5e-5 * std::log(1 - 1.425 / 1.5);
  // At the ramp's end the speed is 3e-5 m/s: (v/v_s)^2 and sigma2 v are 1e-3 and 1e-5 of the force, and the
  // slope of ln near its pole makes 2 % of it.
  EXPECT_NEAR(mass.x_m, expected, 0.03 * expected);
}

TEST(LuGre, PreslidingRampsBackAndForthFollowTheirHysteresis) {
  // The paper's other half: from 1.425 N down to -1.425 N and up again, at 0.1425 N/s.
  const auto law = make_law("lugre", canudas());
  SlidingMass mass{{*law, canudas_load(4000)}};
  const auto ramp = [](double, double t) {
    const double up_down = std::abs(std::fmod(t - 10, 40) - 20);  // 20 at the top, 0 at the bottom
    return t < 10 ? 0.1425 * t : 0.1425 * (up_down - 10);
  };
  const double z_c = 1.5e-5, share = 1.425 / 1.5;
  while (mass.t_s < 10) mass.tick(ramp);
  const double top_m = mass.x_m;
  while (mass.t_s < 30) mass.tick(ramp);
  // Turned round at z1 = 0.95 z_c the bristle yields as z = -z_c + (z1 + z_c) e^(-|dx|/z_c).
  const double way_m = z_c * std::log((1 + share) / (1 - share));
  EXPECT_NEAR(top_m - mass.x_m, way_m, 0.03 * way_m);  // as in the ramp above
  const double bottom_m = mass.x_m;
  while (mass.t_s < 50) mass.tick(ramp);
  EXPECT_NEAR(mass.x_m - bottom_m, way_m, 0.03 * way_m);
}

TEST(LuGre, HoldsWhereEulersStepDiverges) {
  // Explicit Euler needs sigma0 |v| T/g < 2; here it is 5000.
  const auto law = make_law("lugre", canudas());
  PlaneContact contact{*law, canudas_load(1000)};
  contact.move_to({0, 0});
  for (int k = 1; k < 200; ++k) {
    const double way = 0.05 * k;  // 50 m/s
    contact.move_to({way, 0});
    EXPECT_LE(contact.state.stretch_m.norm(), 1.5e-5 * (1 + 1e-12));
  }
  EXPECT_NEAR(contact.state.stretch_m.x(), 1e-5, 1e-15);  // F_c/sigma0
}

/// Elasto-plastic bristle by its equations as Dupont 2002 prints them, on a line, in steps so small that the
/// first order does. sigma1 = sigma2 = 0, g = F_s.
double integrated_bristle_m(double way_m, double z_ba, double z_ss) {
  double z = 0;
  const int steps = 2000000;
  for (int i = 0; i < steps; ++i) {
    const double size = std::abs(z);
    double alpha = 0;
    if (z * way_m > 0 && size > z_ba) {
      alpha = size >= z_ss
                  ? 1
                  : 0.5 + 0.5 * std::sin(std::numbers::pi * (size - (z_ss + z_ba) / 2) / (z_ss - z_ba));
    }
    const double dx = way_m / steps;
    z += dx - alpha * z / z_ss * std::abs(dx);
  }
  return z;
}

TEST(ElastoPlastic, FollowsItsPublishedEquations) {
  const auto law = make_law("elasto-plastic", settings_of({{"stribeck_speed_m_per_s", 1e6}}));  // g = F_s
  for (const double way_m : {2.0e-4, 2.6e-4, 3.5e-4, -5e-4, 1.5e-3}) {
    PlaneContact contact{*law, pressed(1, 1000)};
    contact.move_to({0, 0});
    for (int k = 1; k <= 1000; ++k) contact.move_to({way_m * k / 1000, 0});
    // Steps of 1.5e-6 m against z_ss = 3e-4 m, second order: (5e-3)^2 of the bristle times a few.
    EXPECT_NEAR(contact.state.stretch_m.x(), integrated_bristle_m(way_m, 0.7 * 3e-4, 3e-4), 3e-9) << way_m;
  }
}

TEST(MaxDisplacement, SmoothFormFollowsItsPublishedEquation) {
  // dw = |dx| alpha(z) z, alpha = z^8/(z_max (z_stick^8 + z^8)), integrated by tiny steps of first order;
  // over ways after which the hard limit, which stays, is not yet reached.
  const double z_max = 2e-4, z_stick = 1.5e-4;
  const auto law = make_law("max-displacement", settings_of({{"stick_displacement_m", z_stick}}));
  for (const double way_m : {1e-4, 1.6e-4, 2.2e-4}) {
    double z = 0;
    for (int i = 0; i < 200000; ++i) {
      const double dx = way_m / 200000, eighth = std::pow(z / z_stick, 8);
      z += dx - dx * eighth / (z_max * (1 + eighth)) * z;
    }
    PlaneContact contact{*law, pressed(1, 1000)};
    contact.move_to({0, 0});
    for (int k = 1; k <= 4000; ++k) contact.move_to({way_m * k / 4000, 0});
    ASSERT_LT(z, z_max);
    EXPECT_NEAR(contact.state.stretch_m.x(), z, 2e-4 * z_max);  // first order: steps of 3e-4 of z_max
  }
}

/// How far a mass has drifted over 18 s under 0.5 + 0.3 sin N at 5 Hz (Dupont 2002), from the end of its
/// first period.
double presliding_drift_m(const FrictionLaw& law, const TangentialMotion& motion, double damping_n_s_per_m) {
  SlidingMass mass{{law, motion}};
  mass.damping_n_s_per_m = damping_n_s_per_m;
  const auto push = [](double, double t) { return 0.5 + 0.3 * std::sin(2 * std::numbers::pi * 5 * t); };
  const int per_period = static_cast<int>(std::lround(0.2 / motion.dt_s));
  for (int k = 0; k < per_period; ++k) mass.tick(push);
  const double start = mass.x_m;
  for (int k = 0; k < 89 * per_period; ++k) mass.tick(push);
  return mass.x_m - start;
}

TEST(PreslidingDrift, LuGreDriftsAsPublished) {
  const double drift = presliding_drift_m(*make_law("lugre", canudas()), canudas_load(10000), 0);
  EXPECT_NEAR(drift, 4.4e-4, 0.1 * 4.4e-4);
}

TEST(PreslidingDrift, ElastoPlasticDoesNotDrift) {
  const double drift = presliding_drift_m(*make_law("elasto-plastic", canudas()), canudas_load(10000), 0);
  EXPECT_LT(std::abs(drift), 1e-8);
}

TEST(PreslidingDrift, MaxDisplacementDoesNotDrift) {
  TangentialMotion motion = canudas_load(10000);
  motion.mu_dynamic = motion.mu_static;  // one coefficient: give it the breakaway force
  const auto law = make_law("max-displacement", settings_of({{"max_displacement_m", 1.5e-5}}));
  // The law has no damping of its own; the mass gets LuGre's sigma1.
  EXPECT_LT(std::abs(presliding_drift_m(*law, motion, std::sqrt(1e5))), 1e-8);
}

TEST(PreslidingDrift, FingerPadsCentreDoesNotMoveAtAll) {
  const auto law = make_law("finger-pad", settings_of({{"stick_stiffness_per_m", 1e5}}));
  SlidingMass mass{{*law, canudas_load(10000)}};
  mass.damping_n_s_per_m = std::sqrt(1e5);
  const auto push = [](double, double t) { return 0.5 + 0.3 * std::sin(2 * std::numbers::pi * 5 * t); };
  mass.tick(push);
  const Vec2 centre = mass.contact.centre_m;
  for (int k = 0; k < 180000; ++k) {
    mass.tick(push);
    ASSERT_EQ(mass.friction.phase, Phase::stick);
    ASSERT_EQ(mass.contact.centre_m, centre);
  }
}

TEST(ElastoPlastic, IsElasticBelowItsShareOfTheLimit) {
  const auto law = make_law("elasto-plastic");
  PlaneContact contact{*law, pressed(1, 100)};  // 1e-4 m/s, far below v_s
  contact.move_to({0, 0});
  for (int k = 1; k <= 200; ++k) contact.move_to({1e-6 * k, 0});  // 0.2 of 0.3 mm; z_ba is 0.21
  for (int k = 200; k >= 0; --k) contact.move_to({1e-6 * k, 0});
  EXPECT_NEAR(contact.state.stretch_m.norm(), 0, 1e-18);
}

TEST(ElastoPlastic, YieldsAlikeInBothDirections) {
  // Public codes put the signed deflection into alpha's sine: then one direction yields and the other does
  // not.
  const auto law = make_law("elasto-plastic");
  PlaneContact right{*law, pressed(1, 1000)}, left{*law, pressed(1, 1000)};
  for (int k = 0; k < 2000; ++k) {
    const double x = 1e-3 * std::sin(0.01 * k);
    const Vec2 a = right.move_to({x, 0}).force_n, b = left.move_to({-x, 0}).force_n;
    ASSERT_EQ(a.x(), -b.x());
  }
}

TEST(ElastoPlastic, StretchIsMonotoneUpToTheSteadyOne) {
  const auto law =
      make_law("elasto-plastic", settings_of({{"stribeck_speed_m_per_s", 1e3}}));  // z_ss = F_s/sigma0
  for (const double sign : {1.0, -1.0}) {
    PlaneContact contact{*law, pressed(1, 1000)};
    contact.move_to({0, 0});
    double last = 0;
    for (int k = 1; k < 6000; ++k) {  // 20 bristle lengths
      const double f = -sign * contact.move_to({sign * 1e-6 * k, 0}).force_n.x();
      ASSERT_GE(f, last - rounding);
      last = f;
    }
    EXPECT_NEAR(last, mu_s, 1e-6);
  }
}

}  // namespace
}  // namespace fingerpad::bristle_laws_test
