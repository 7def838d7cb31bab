#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "support/sliding_mass.hpp"

namespace fingerpad::pulled_block_test {
namespace {

using test::make_law;
using test::pressed;
using test::settings_of;
using test::SlidingMass;

/// A block of 1 kg pulled by a spring of 20 N/m; friction 3 N at most, 2 N sliding (SCIENCE 3).
constexpr double mass_kg = 1, spring_n_per_m = 20, static_n = 3, dynamic_n = 2, normal_n = 10;

/// A block on a rigid stick, pulled: what a cycle of it is.
struct Pulled {
  double spring_n_per_m = 20, static_n = 3, dynamic_n = 2, speed = 0.05, damping = 0;
};
struct RigidCycle {
  double slip_s, stick_s, jump_m, least_pull_n, fastest;
  double period_s() const { return slip_s + stick_s; }
};

/// Slip from rest at a pull of F_s until v = 0, then rest until F_s again, stepped through in time.
RigidCycle rigid_cycle_of(const Pulled& p) {
  double x = 0, v = 0, t = 0, fastest = 0;
  const double stretch = p.static_n / p.spring_n_per_m, h = 1e-6;
  const auto acceleration = [&](double x_, double v_, double t_) {
    return (p.spring_n_per_m * (stretch + p.speed * t_ - x_) - p.dynamic_n - p.damping * v_) / mass_kg;
  };
  do {  // midpoint rule; at a step of 1e-6 s its error is far below every tolerance here
    const double xm = x + h / 2 * v, vm = v + h / 2 * acceleration(x, v, t);
    v += h * acceleration(xm, vm, t + h / 2);
    x += h * vm;
    t += h;
    fastest = std::max(fastest, v);
  } while (v > 0);
  const double pull = p.spring_n_per_m * (stretch + p.speed * t - x);
  return {t, (p.static_n - pull) / (p.spring_n_per_m * p.speed), x, pull, fastest};
}

double rigid_period_s(double speed, double damping) {
  return rigid_cycle_of({.speed = speed, .damping = damping}).period_s();
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

/// Least and greatest pull from `from_s` on.
struct Swing {
  double least_n = 1e9, most_n = -1e9;
};
Swing swing_of(const FrictionLaw& law, double speed, double damping, double rate_hz, double seconds,
               double from_s = 20) {
  SlidingMass block{{law, pressed(normal_n, rate_hz)}};
  block.damping_n_s_per_m = damping;
  const auto pull = [&](double x, double t) { return spring_n_per_m * (speed * t - x); };
  Swing swing;
  while (block.t_s < seconds) {
    block.tick(pull);
    if (block.t_s < from_s) continue;
    swing.least_n = std::min(swing.least_n, pull(block.x_m, block.t_s));
    swing.most_n = std::max(swing.most_n, pull(block.x_m, block.t_s));
  }
  return swing;
}

TEST(PulledBlock, RigidReferenceMeetsTheClosedForm) {
  for (const double speed : {0.02, 0.05, 0.3}) {
    const RigidCycle cycle = rigid_cycle_of({.speed = speed});
    const double lambda = std::sqrt(spring_n_per_m / mass_kg), a = (static_n - dynamic_n) / spring_n_per_m;
    const double slip_s = 2 / lambda * (std::numbers::pi - std::atan(lambda * a / speed));
    // The integrator's last step is 1e-6 s long, at a speed near 0; sums of 1e6 steps round at 1e-10.
    EXPECT_NEAR(cycle.slip_s, slip_s, 2e-6);
    EXPECT_NEAR(cycle.stick_s, 2 * a / speed, 1e-6);
    EXPECT_NEAR(cycle.jump_m, 2 * a + speed * slip_s, 1e-7);
    EXPECT_NEAR(cycle.least_pull_n, 2 * dynamic_n - static_n,
                1e-5);  // the pull goes on rising by k V a second
    EXPECT_NEAR(cycle.fastest, speed + std::sqrt(speed * speed + lambda * lambda * a * a), 1e-9);
  }
  EXPECT_NEAR(rigid_period_s(0.05, 0), 2.80086, 1e-5);  // SCIENCE 3, to its digits
}

TEST(PulledBlock, DampedStickSlipMeetsTheRigidOracle) {
  const auto law =
      make_law("stick-slip", settings_of({{"stick_stiffness_per_m", 500}, {"v_min_m_per_s", 0.002}}));
  const double expected = rigid_period_s(0.02, 2);
  // SCIENCE 3: within 0.3 % at k_f = 500 1/m and 10 kHz; 0.5 % is asked of the hand in the loop.
  EXPECT_NEAR(period_s(*law, 0.02, 2, 10000, 60), expected, 0.005 * expected);
}

TEST(PulledBlock, AtTheDefaultVMinTheLevelRuleResticksEarly) {
  LawSettings settings = settings_of({{"stick_stiffness_per_m", 500}});
  const Pulled rigid{.speed = 0.02, .damping = 2};
  const RigidCycle expected = rigid_cycle_of(rigid);
  // v_min = 0.1 m/s is about as fast as the block gets. While it is slower, the level rule makes its slip a
  // sawtooth of mean (F_s + F_d)/2 = 2.5 N, so the pull falls little below that, and the stick that follows
  // is entered with the block still moving: it rings and breaks below F_s. SCIENCE 3 names a third of the
  // period. Measured here: the pull swings by 0.31 of the rigid stick's swing (2.37..2.82 N against 1.57..3
  // N), while the period of the teeth, which differ from one to the next, is 0.41 of the rigid one over all,
  // and 0.47 over those of a quarter newton and more, as counted by period_s. True or differenced speed gives
  // the same.
  // Between ticks the teeth are whole and the sawtooth's mean is met: the swing is smaller still.
  for (const Events events : {Events::tick, Events::exact}) {
    settings.events = events;
    const double period = period_s(*make_law("stick-slip", settings), 0.02, 2, 10000, 60);
    EXPECT_GT(period, 0.3 * expected.period_s());
    EXPECT_LT(period, 0.55 * expected.period_s());
    const Swing swing = swing_of(*make_law("stick-slip", settings), 0.02, 2, 10000, 60);
    const double share = (swing.most_n - swing.least_n) / (static_n - expected.least_pull_n);
    EXPECT_NEAR(share, events == Events::tick ? 1.0 / 3 : 1.0 / 4, 0.04);
  }
  // The other reading of eq. 1 never sticks again: it slides on at a pull of F_d + b V.
  settings.restick = Restick::crossing;
  const Swing sliding = swing_of(*make_law("stick-slip", settings), 0.02, 2, 10000, 60);
  EXPECT_NEAR(sliding.least_n, dynamic_n + 2 * 0.02, 1e-3);
  EXPECT_NEAR(sliding.most_n, dynamic_n + 2 * 0.02, 1e-3);
}

TEST(PulledBlock, UndampedThePapersStickBreaksAtAPullOfTheSlidingForceWhateverItsStiffness) {
  // Stick is a spring entered at F_d with the block at rest and the pull at 2 F_d - F_s: it rings by F_s -
  // F_d about the pull, and reaches F_s when the pull is F_d. The device's damper is what the held spring
  // gives back, K T/2, so that the ringing neither grows nor dies.
  const double speed = 0.005, rate_hz = 20000;
  for (const double k_f : {20.0, 50.0, 100.0}) {
    LawSettings settings = settings_of({{"stick_stiffness_per_m", k_f}, {"v_min_m_per_s", 0.002}});
    settings.restick = Restick::crossing;  // the level rule would stick again on the tick after it broke
    const auto law = make_law("stick-slip", settings);
    SlidingMass block{{*law, pressed(normal_n, rate_hz)}};
    block.damping_n_s_per_m = k_f * normal_n / rate_hz / 2;
    const auto pull = [&](double x, double t) { return spring_n_per_m * (speed * t - x); };
    // At its first break, out of true rest, the pull is F_s, after 30 s; the next that ends half a second of
    // stick is the one to look at.
    double slipped_s = 0, breaks_at_n = 0;
    while (block.t_s < 60 && breaks_at_n == 0) {
      const bool stuck = block.friction.phase == Phase::stick;
      const double now = pull(block.x_m, block.t_s);
      block.tick(pull);
      if (block.friction.phase != Phase::slip) continue;
      if (slipped_s == 0) {
        EXPECT_NEAR(now, static_n, 0.01);
      } else if (stuck && block.t_s > slipped_s + 0.5) {
        breaks_at_n = now;
      }
      slipped_s = block.t_s;
    }
    // The ringing peaks once a turn, meanwhile the pull rises by k V: so much later may a peak meet F_s. The
    // stick begins at up to v_min, and ten seconds of ringing are compensated to the first order of T: 2 % of
    // the swing.
    const double turn_s = 2 * std::numbers::pi / std::sqrt((k_f * normal_n + spring_n_per_m) / mass_kg);
    EXPECT_GT(breaks_at_n, dynamic_n - 0.02) << k_f;
    EXPECT_LT(breaks_at_n, dynamic_n + spring_n_per_m * speed * turn_s + 0.02) << k_f;
  }
}

TEST(PulledBlock, LuGrePulledAsInItsOwnPaperMeetsTheRigidCycle) {
  // Canudas de Wit 1995: 1 kg, k = 2 N/m, V = 0.1 m/s; F_s = 1.5 N, F_c = 1 N, sigma2 = 0.4 N s/m.
  const auto law = make_law("lugre", settings_of({{"stick_stiffness_n_per_m", 1e5},
                                                  {"bristle_damping_n_s_per_m", std::sqrt(1e5)},
                                                  {"viscous_n_s_per_m", 0.4},
                                                  {"stribeck_speed_m_per_s", 1e-3}}));
  TangentialMotion load = pressed(1, 10000);
  load.mu_static = 1.5;
  load.mu_dynamic = 1;
  SlidingMass block{{*law, load}};
  const auto pull = [](double x, double t) { return 2 * (0.1 * t - x); };
  std::vector<double> breaks_s, breaks_n, stops_n;
  double most = 0;
  bool slipping = false;
  while (block.t_s < 45) {
    block.tick(pull);
    const double now = pull(block.x_m, block.t_s);
    if (!slipping && block.v_m_per_s > 0.05) {
      slipping = true;
      breaks_s.push_back(block.t_s);
      breaks_n.push_back(most);
    } else if (slipping && block.v_m_per_s < 1e-4) {
      slipping = false;
      stops_n.push_back(now);
      most = now;
    }
    most = std::max(most, now);
  }
  const RigidCycle rigid =
      rigid_cycle_of({.spring_n_per_m = 2, .static_n = 1.5, .dynamic_n = 1, .speed = 0.1, .damping = 0.4});
  ASSERT_GE(breaks_s.size(), 4U);
  const auto last = breaks_s.size() - 1;
  // The bristle's limit falls from F_s within v_s of rest, and it creeps by z_c = 15 um before: a percent.
  EXPECT_NEAR((breaks_s[last] - breaks_s[1]) / static_cast<double>(last - 1), rigid.period_s(),
              0.02 * rigid.period_s());
  EXPECT_NEAR(breaks_n[last], 1.5, 0.02 * 1.5);
  EXPECT_NEAR(stops_n[1], rigid.least_pull_n, 0.02 * 1.5);
}

TEST(SlidingStop, TakesTheTimeAndWayOfConstantDeceleration) {
  const auto law = make_law("stick-slip", settings_of({{"v_min_m_per_s", 1e-4}}));
  const double g = 9.81, v0 = 1;
  SlidingMass block{{*law, pressed(g, 10000)}};
  block.v_m_per_s = v0;
  block.contact.slide_to({0, 0}, {v0, 0});
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
}  // namespace fingerpad::pulled_block_test
