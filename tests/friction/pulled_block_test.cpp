#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/sliding_mass.hpp"

namespace fingerpad {
namespace {

using test::make_law;
using test::pressed;
using test::settings_of;
using test::SlidingMass;

/// A block of 1 kg pulled by a spring of 20 N/m; friction 3 N at most, 2 N sliding (SCIENCE 3).
constexpr double mass_kg = 1, spring_n_per_m = 20, static_n = 3, dynamic_n = 2, normal_n = 10;

/// The period of a block whose stick is rigid: slip from rest at a pull of F_s until v = 0, then rest until
/// F_s again.
double rigid_period_s(double speed, double damping) {
  double x = 0, v = 0, t = 0;
  const double stretch = static_n / spring_n_per_m, h = 1e-6;
  const auto acceleration = [&](double x_, double v_, double t_) {
    return (spring_n_per_m * (stretch + speed * t_ - x_) - dynamic_n - damping * v_) / mass_kg;
  };
  do {  // midpoint rule; at a step of 1e-6 s its error is far below every tolerance here
    const double xm = x + h / 2 * v, vm = v + h / 2 * acceleration(x, v, t);
    v += h * acceleration(xm, vm, t + h / 2);
    x += h * vm;
    t += h;
  } while (v > 0);
  const double pull = spring_n_per_m * (stretch + speed * t - x);
  return t + (static_n - pull) / (spring_n_per_m * speed);
}

/// Mean time between ruptures out of a long stick, over the last teeth of a run.
double period_s(const FrictionLaw& law, double speed, double damping, double rate_hz, double seconds) {
  SlidingMass block{{law, pressed(normal_n, rate_hz)}};
  block.damping_n_s_per_m = damping;
  const auto pull = [&](double x, double t) { return spring_n_per_m * (speed * t - x); };
  std::vector<double> peaks;
  double last_pull = 0;
  bool loading = false;
  while (block.t_s < seconds) {
    block.tick(pull);
    // The spring's pull rises slowly through the stick and falls fast in the slip: a tooth ends where it has
    // fallen by a quarter of F_s - F_d.
    const double now = pull(block.x_m, block.t_s);
    if (loading && now < last_pull - (static_n - dynamic_n) / 4) {
      peaks.push_back(block.t_s);
      loading = false;
      last_pull = now;
    } else if (!loading) {
      if (now < last_pull) last_pull = now;
      if (now > last_pull + (static_n - dynamic_n) / 4) {
        loading = true;
        last_pull = now;
      }
    } else if (now > last_pull) {
      last_pull = now;
    }
  }
  if (peaks.size() < 3) return std::nan("");
  return (peaks.back() - peaks[1]) / static_cast<double>(peaks.size() - 2);
}

TEST(PulledBlock, RigidReferenceMeetsTheClosedForm) {
  EXPECT_NEAR(rigid_period_s(0.05, 0), 2.80086, 1e-4);  // SCIENCE 3, to its digits plus the step's 1e-6 s
}

TEST(PulledBlock, DampedStickSlipMeetsTheRigidOracle) {
  const auto law =
      make_law("stick-slip", settings_of({{"stick_stiffness_per_m", 500}, {"v_min_m_per_s", 0.002}}));
  const double expected = rigid_period_s(0.02, 2);
  // SCIENCE 3: within 0.3 % at k_f = 500 1/m and 10 kHz; 0.5 % is asked of the hand in the loop.
  EXPECT_NEAR(period_s(*law, 0.02, 2, 10000, 60), expected, 0.005 * expected);
}

TEST(PulledBlock, TheLevelRuleAtTheDefaultVMinResticksEarly) {
  const auto law = make_law("stick-slip", settings_of({{"stick_stiffness_per_m", 500}}));
  const double expected = rigid_period_s(0.02, 2);
  // v_min = 0.1 m/s lies above most of the slip's speed. SCIENCE 3 names a third of the period; counted by
  // teeth of the pull it is 0.48 here (2.069 s), and the claim tested is that it is far too short.
  const double measured = period_s(*law, 0.02, 2, 10000, 60);
  EXPECT_GT(measured, 0.2 * expected);
  EXPECT_LT(measured, 0.6 * expected);
}

TEST(SlidingStop, TakesTheTimeAndWayOfConstantDeceleration) {
  const auto law = make_law("stick-slip", settings_of({{"v_min_m_per_s", 1e-4}}));
  const double g = 9.81, v0 = 1;
  SlidingMass block{{*law, pressed(g, 10000)}};
  block.v_m_per_s = v0;
  const auto nothing = [](double, double) { return 0.0; };
  do block.tick(nothing);
  while (block.friction.phase == Phase::slip);
  const double time_s = block.t_s - block.contact.motion.dt_s;
  const double way_m = block.contact.at_m.x();
  // A tick of 1e-4 s and the last 1e-4 m/s: 2e-4 of the time each.
  EXPECT_NEAR(time_s, v0 / (0.2 * g), 3e-4);
  EXPECT_NEAR(way_m, v0 * v0 / (2 * 0.2 * g), 1e-3 * v0 * v0 / (2 * 0.2 * g));
}

}  // namespace
}  // namespace fingerpad
