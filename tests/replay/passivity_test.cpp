#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "replay/figures.hpp"
#include "support/finger_runs.hpp"
#include "support/worlds.hpp"
#include "touch/touch.hpp"

namespace fingerpad::passivity_test {
namespace {

double figure(const Figures& figures, std::string_view wanted) {
  const auto names = Figures::names();
  const auto at = std::find(names.begin(), names.end(), wanted) - names.begin();
  return figures.values()[static_cast<std::size_t>(at)];
}

/// A tick at a depth below the surface z = 0, under a force along z.
TickRecord tick_at(double z_m, double force_n) {
  TickRecord record;
  record.phase = force_n > 0 ? Phase::stick : Phase::free;
  record.p_WQ = Vec3(0, 0, z_m);
  record.force_W_n = Vec3(0, 0, force_n);
  record.normal_W = Vec3::UnitZ();
  return record;
}

TEST(Passivity, AHeldSpringGivesBackMoreThanItTook) {
  // In and out of a wall of 1000 N/m in steps of 1 mm: on the way in the force held over a step is the
  // smaller one, on the way out the larger one. Taken 1 mJ (0 N, then 1 N), given 3 mJ (2 N, then 1 N).
  Figures figures;
  for (const double depth_mm : {0.0, 1.0, 2.0, 1.0, 0.0})
    figures.observe(tick_at(-1e-3 * depth_mm, depth_mm));
  EXPECT_NEAR(figure(figures, "energy_made_j"), 2e-3, 1e-15);
}

TEST(Passivity, AFingerThatOnlyGoesInGetsNothing) {
  Figures figures;
  for (int k = 0; k < 5; ++k) figures.observe(tick_at(-1e-3 * k, k));
  EXPECT_EQ(figure(figures, "energy_made_j"), 0);
}

TEST(Passivity, WhatAFirstTickInsideStoresIsNotMade) {
  // Let go from 2 mm deep in a wall of 1000 N/m, in steps of a micrometre: the spring gives back the 2 mJ
  // that it held, and the held forces a thousandth of it more (half a step at each).
  Figures figures;
  for (int um = 2000; um >= 0; --um) {
    TickRecord record = tick_at(-1e-6 * um, 1e-3 * um);
    record.normal_force_n = 1e-3 * um;
    record.depth_m = 1e-6 * um;
    figures.observe(record);
  }
  EXPECT_NEAR(figure(figures, "energy_made_j"), 1e-6, 1e-12);
}

/// A groove along y of two planes that meet in a right angle at the origin.
std::shared_ptr<const World> groove(double left_n_per_m, double right_n_per_m) {
  auto world = std::make_shared<World>();
  for (const double side : {1.0, -1.0}) {
    world->surfaces.push_back(test::plane_surface(Vec3::Zero(), Vec3(side, 0, 1).normalized()));
    world->surfaces.back().properties.stiffness_n_per_m = side > 0 ? left_n_per_m : right_n_per_m;
  }
  return world;
}

/// What a point's forces give that is let go `start` below a groove's bottom, straight up in steps of 1 um.
double made_from_groove_j(const std::shared_ptr<const World>& world, const Vec3& start) {
  Scene scene = test::plane_scene("none");
  scene.contact.method = "proxy";
  Touch touch(world, scene);
  Figures figures;
  const int steps = static_cast<int>(std::lround(start.norm() / 1e-6));
  for (int k = 0; k <= steps; ++k) {
    const FingerSample sample{1e-3 * k, start * (1 - static_cast<double>(k) / steps)};
    const TickRecord record = touch.tick(sample);
    if (k == 0) {
      EXPECT_EQ(record.walls, 2);
      EXPECT_GT(record.normal_force_n, 1.2 * record.force_W_n.norm()) << "the walls push against each other";
    }
    figures.observe(record);
  }
  return figure(figures, "energy_made_j");
}

TEST(Passivity, WhatTheWallsOfAGrooveStoreIsNotMadeAndNoMoreThanThat) {
  // 2 mm deep, k d^2 / 2 = 2 mJ of walls at right angles, and held forces half a step more: a thousandth.
  EXPECT_NEAR(made_from_groove_j(groove(1000, 1000), Vec3(0, 0, -0.002)), 1e-6, 1e-9);
  // Walls of two stiffnesses: each is pressed by d / sqrt 2, and both together hold (k1 + k2) d^2 / 4.
  EXPECT_NEAR(made_from_groove_j(groove(500, 1500), Vec3(0, 0, -0.002)), 1e-6, 1e-9);
}

TEST(Passivity, CountsTheTicksOnWhichARemedyActed) {
  Figures figures;
  for (int k = 0; k < 5; ++k) {
    TickRecord record = tick_at(-1e-3, 1);
    record.remedied = k > 2;
    figures.observe(record);
  }
  EXPECT_EQ(figure(figures, "remedied_ticks"), 2);
}

TEST(Passivity, CountsTheTicksWhoseProxyHadNotSettledInTouchOrNot) {
  Figures figures;
  for (int k = 0; k < 7; ++k) {
    TickRecord record = tick_at(k < 4 ? -1e-3 : 1e-3, k < 4 ? 1 : 0);
    record.unsettled = k == 1 || k > 3;
    figures.observe(record);
  }
  EXPECT_EQ(figure(figures, "unsettled_ticks"), 4);
}

}  // namespace
}  // namespace fingerpad::passivity_test
