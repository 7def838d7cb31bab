#include "study/stable_stiffness.hpp"

#include <gtest/gtest.h>

#include <iterator>
#include <span>

#include "support/effort.hpp"

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

TEST(StableStiffness, TheSimulatedHandFindsEveryPublishedLimit) {
  // Under the sanitizers the first alone: the others go the same way.
  for (const Row& row : std::span(rows).first(test::sanitized() ? 1 : std::size(rows))) {
    // 2 % is what the issue asks; the bisection stops at 0.2 %, and ten seconds tell decay from growth to
    // about as much.
    EXPECT_NEAR(measured_stable_stiffness(row.wall), row.stiffness_n_per_m, 0.02 * row.stiffness_n_per_m)
        << "B " << row.wall.wall_damping_n_s_per_m << " d " << row.wall.delay_ticks;
  }
}

}  // namespace
}  // namespace fingerpad::stable_stiffness_test
