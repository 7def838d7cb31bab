#include "motion/stable_stiffness.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <deque>

namespace fingerpad::stable_stiffness_test {
namespace {

struct Row {
  HeldWall wall;
  double stiffness_n_per_m;
};

/// SCIENCE 4, the table of largest stable stiffnesses: m = 0.072 kg, b = 0.5 N s/m.
const Row rows[] = {
    {{.tick_s = 1e-3, .delay_ticks = 0}, 1001},
    {{.tick_s = 1e-3, .delay_ticks = 1}, 334},
    {{.tick_s = 1e-3, .delay_ticks = 2}, 200.6},
    {{.tick_s = 1e-4, .delay_ticks = 0}, 10001},
    {{.wall_damping_n_s_per_m = 2, .tick_s = 1e-3}, 4869},
    {{.wall_damping_n_s_per_m = 20, .tick_s = 1e-3}, 31068},
};

TEST(StableStiffness, IsThatOfEveryPublishedRow) {
  for (const Row& row : rows) {
    // The table's last digit is a unit, or a tenth of one.
    EXPECT_NEAR(stable_stiffness(row.wall), row.stiffness_n_per_m, 6e-4 * row.stiffness_n_per_m);
  }
}

/// How many times as far the finger swings in the last quarter as in the second one, let go at 1 m/s on the
/// wall: the loop of HeldWall, each tick in short steps.
double growth(const HeldWall& wall, double stiffness_n_per_m, long ticks) {
  constexpr int steps = 20;
  const double m = wall.mass_kg, h = wall.tick_s / steps;
  std::deque<double> on_the_way(static_cast<std::size_t>(wall.delay_ticks) + 1, 0.0);
  double x = 0, v = 1, last = 0, early = 0, late = 0;
  for (long tick = 0; tick < ticks; ++tick) {
    on_the_way.push_front(-stiffness_n_per_m * x - wall.wall_damping_n_s_per_m * (x - last) / wall.tick_s);
    on_the_way.pop_back();
    last = x;
    const auto pull = [&](double at, double speed) {
      return (on_the_way.back() - wall.damping_n_s_per_m * speed - wall.hand_stiffness_n_per_m * at) / m;
    };
    for (int step = 0; step < steps; ++step) {  // by the midpoint
      const double a = pull(x, v), half_x = x + h / 2 * v, half_v = v + h / 2 * a;
      x += h * half_v;
      v += h * pull(half_x, half_v);
    }
    if (tick >= ticks / 4 && tick < ticks / 2) early = std::max(early, std::abs(x));
    if (tick >= 3 * ticks / 4) late = std::max(late, std::abs(x));
  }
  return late / early;
}

TEST(StableStiffness, BelowItTheLoopCalmsDownAndAboveItGrowsWhateverTheDelay) {
  for (const int delay_ticks : {0, 1, 7, 30, 100}) {
    for (const double wall_damping : {0.0, 0.3}) {
      for (const double hand_stiffness : {0.0, 20.0, 200.0, 3000.0}) {
        const HeldWall wall{.hand_stiffness_n_per_m = hand_stiffness,
                            .wall_damping_n_s_per_m = wall_damping,
                            .delay_ticks = delay_ticks};
        const double most = stable_stiffness(wall);
        const long ticks = 1000L * (delay_ticks + 5);
        if (most == 0) {
          EXPECT_GT(growth(wall, 1e-3, ticks), 1.02);
          continue;
        }
        EXPECT_LT(growth(wall, 0.97 * most, ticks), 0.95)
            << delay_ticks << " " << wall_damping << " " << hand_stiffness << " " << most;
        EXPECT_GT(growth(wall, 1.03 * most, ticks), 1.05)
            << delay_ticks << " " << wall_damping << " " << hand_stiffness << " " << most;
      }
    }
  }
  // A damper stronger than what holds the finger, felt late: no wall is soft enough.
  EXPECT_EQ(stable_stiffness({.wall_damping_n_s_per_m = 0.6, .delay_ticks = 1500}), 0);
}

/// Without a mass to speak of x goes to F/k by e = exp(-k T/b) a tick: K = k (1 + e)/(1 - e).
TEST(StableStiffness, OfAFingerThatIsAllDamperIsInClosedForm) {
  for (const double damping : {1.0, 1e3, 1e9}) {
    const HeldWall wall{
        .mass_kg = 1e-6, .damping_n_s_per_m = damping, .hand_stiffness_n_per_m = 200, .tick_s = 1e-2};
    const double gone = -std::expm1(-200 * wall.tick_s / damping), exact = 200 * (2 - gone) / gone;
    EXPECT_NEAR(stable_stiffness(wall), exact, 1e-4 * exact) << damping;
  }
}

TEST(StableStiffness, PublishedConditionsStandAtOrBelowTheExactValue) {
  for (const Row& row : rows) {
    if (row.wall.delay_ticks > 0) continue;  // they are for a loop without delay
    // Passivity is stricter than stability; the finger's inertia leaves a thousandth between them where B =
    // 0.
    EXPECT_LE(colgate_schenkel_stiffness(row.wall), row.stiffness_n_per_m);
    if (row.wall.wall_damping_n_s_per_m > 0) continue;
    EXPECT_LE(abbott_okamura_stiffness(row.wall), row.stiffness_n_per_m);
    EXPECT_NEAR(colgate_schenkel_stiffness(row.wall), row.stiffness_n_per_m, 2e-3 * row.stiffness_n_per_m);
  }
}

TEST(StableStiffness, TheRuleOfThumbIsTheTablesLastColumn) {
  const double thumb[] = {1000, 1000.0 / 3, 200, 10000, 5000, 41000};
  for (std::size_t i = 0; i < std::size(rows); ++i)
    EXPECT_NEAR(thumb_stiffness(rows[i].wall), thumb[i], 1e-6);
}

TEST(StableStiffness, ConditionsOfTheLiterature) {
  HeldWall wall;
  EXPECT_DOUBLE_EQ(colgate_schenkel_stiffness(wall), 1000);
  wall.wall_damping_n_s_per_m = 0.2;
  EXPECT_DOUBLE_EQ(colgate_schenkel_stiffness(wall), 600);
  EXPECT_TRUE(std::isnan(abbott_okamura_stiffness(wall)));
  wall = {.encoder_m = 3e-5, .coulomb_n = 0.006};
  EXPECT_DOUBLE_EQ(abbott_okamura_stiffness(wall), 400);
  wall.delay_ticks = 1;
  EXPECT_TRUE(std::isnan(colgate_schenkel_stiffness(wall)));
}

}  // namespace
}  // namespace fingerpad::stable_stiffness_test
