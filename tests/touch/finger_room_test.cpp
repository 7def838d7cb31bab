#include "touch/finger_room.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/shapes.hpp"
#include "support/worlds.hpp"

namespace fingerpad::finger_room_test {
namespace {

/// Two blocks whose tops are z = 0, six millimetres apart along x.
World slot(bool closed) {
  const TriangleSoup block = test::moved(test::box_soup({0.05, 0.1, 0.03}), {0, 0, -0.015});
  World world =
      *test::world_of(test::joined(test::moved(block, {0.028, 0, 0}), test::moved(block, {-0.028, 0, 0})));
  world.verdicts.emplace_back().closed = closed;
  return world;
}

TEST(FingerRoom, ABallThatComesDownIntoASlotStopsOnItsEdges) {
  for (const bool closed : {true, false}) {
    const World world = slot(closed);
    for (const double radius_m : {0.0035, 0.007, 0.02}) {
      const Vec3 at_W = stopped_on_line(world, {0, 0, -0.02}, Vec3::UnitZ(), 0.1, radius_m, 1e-6);
      EXPECT_NEAR(at_W.z(), std::sqrt(radius_m * radius_m - 9e-6), 1e-5) << radius_m;
      EXPECT_GE(at_W.z(), std::sqrt(radius_m * radius_m - 9e-6)) << "it stands clear";
    }
    // There is room for this one.
    EXPECT_EQ(stopped_on_line(world, {0, 0, -0.02}, Vec3::UnitZ(), 0.1, 0.002, 1e-6), Vec3(0, 0, -0.02));
  }
}

TEST(FingerRoom, InsideOfAClosedPartIsLessThanNoRoom) {
  for (const bool closed : {true, false}) {
    const World world = slot(closed);
    const NearestSurface inside = nearest_surface(world, {0.02, 0, -0.004}, Normals::facet, 0.01);
    EXPECT_EQ(inside.surface, 0);
    EXPECT_NEAR(inside.clear_m, closed ? -0.004 : 0.004, 1e-6);
    const NearestSurface above = nearest_surface(world, {0.02, 0, 0.004}, Normals::facet, 0.01);
    EXPECT_NEAR(above.clear_m, 0.004, 1e-6);
    const NearestSurface far = nearest_surface(world, {0.02, 0, 0.04}, Normals::facet, 0.01);
    EXPECT_EQ(far.surface, -1);
    EXPECT_EQ(far.clear_m, 0.01);
  }
}

}  // namespace
}  // namespace fingerpad::finger_room_test
