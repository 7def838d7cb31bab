#include "contact/proxy_wall.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "base/random_stream.hpp"

namespace fingerpad::proxy_wall_test {
namespace {

Vec3 random_vector(RandomStream& random) {
  return {random.normal(), random.normal(), random.normal()};
}

TEST(ProxyWall, ProjectionMeetsTheConditionsOfTheOptimum) {
  RandomStream random(3);
  std::array<int, 4> seen{};
  for (int trial = 0; trial < 20000; ++trial) {
    std::vector<ProxyWall> walls(1 + static_cast<std::size_t>(4 * random.uniform()));
    for (ProxyWall& wall : walls) {
      // All walls have the start in front of them; some nearly agree.
      wall.normal = trial % 3 == 0 && &wall != walls.data()
                        ? (walls[0].normal + 1e-4 * random_vector(random)).normalized()
                        : random_vector(random).normalized();
      wall.least_m = -random.uniform();
    }
    const Vec3 goal = 3 * random_vector(random);
    const ProxyProjection p = project_onto_walls(goal, walls, 1e-12);
    ASSERT_TRUE(p.found);
    ++seen[static_cast<std::size_t>(p.wall_count)];
    Vec3 push = Vec3::Zero();
    for (const ProxyWall& wall : walls) ASSERT_GE(wall.normal.dot(p.z), wall.least_m - 1e-12);
    for (std::size_t k = 0; k < p.held_by().size(); ++k) {
      const ProxyWall& wall = p.walls[k];
      // On the wall: rounding of numbers near 10, over the sine of 1e-4 between walls that nearly agree.
      ASSERT_NEAR(wall.normal.dot(p.z), wall.least_m, 1e-10);
      ASSERT_GE(p.share_m[k], 0);
      push += p.share_m[k] * wall.normal;
    }
    ASSERT_LT((p.z - goal - push).norm(), 1e-9) << "the push is made of the walls' normals alone";
  }
  for (const int count : seen) EXPECT_GT(count, 50);
}

TEST(ProxyWall, WallsWithNothingInCommonAreToldSo) {
  const std::array<ProxyWall, 2> walls{ProxyWall{Vec3::UnitX(), 1, 0, 0}, ProxyWall{-Vec3::UnitX(), 1, 0, 1}};
  EXPECT_FALSE(project_onto_walls(Vec3(0, 1, 0), walls, 1e-12).found);
}

TEST(ProxyWall, AWallGivenTwiceCountsOnce) {
  const ProxyWall floor{Vec3::UnitZ(), 0, 0, 0};
  const std::array<ProxyWall, 3> walls{floor, floor, floor};
  const ProxyProjection p = project_onto_walls(Vec3(1, 2, -3), walls, 1e-12);
  ASSERT_TRUE(p.found);
  EXPECT_EQ(p.wall_count, 1);
  EXPECT_EQ(p.share_m[0], 3);
  EXPECT_EQ(p.z, Vec3(1, 2, 0));
}

TEST(HoldingWalls, APassKeepsThoseThatHoldAndOneWithoutAPlaceChangesNothing) {
  const ProxyWall floor{Vec3::UnitZ(), 0, 0, 0}, side{Vec3::UnitX(), 1, 0, 1},
      slope{Vec3(0.6, 0, 0.8), 2, 0, 2}, ceiling{-Vec3::UnitZ(), 1, 0, 3};
  const Vec3 goal(0, 0, -3);
  HoldingWalls walls;
  EXPECT_EQ(walls.project(goal, std::nullopt, 1e-12), goal);
  EXPECT_EQ(walls.project(goal, floor, 1e-12), Vec3::Zero());
  EXPECT_EQ(walls.project(goal, side, 1e-12), Vec3::UnitX());
  EXPECT_EQ(walls.wall_count, 2);
  EXPECT_FALSE(walls.project(goal, ceiling, 1e-12));
  ASSERT_EQ(walls.wall_count, 2);
  EXPECT_EQ(walls.walls[0].triangle, floor.triangle);
  EXPECT_EQ(walls.walls[1].triangle, side.triangle);
  EXPECT_EQ(walls.share_m[0], 3);
  // The slope holds the point off both.
  const auto on_slope = walls.project(goal, slope, 1e-12);
  ASSERT_TRUE(on_slope);
  EXPECT_NEAR(slope.lack_m(*on_slope), 0, 1e-15);  // rounding of 1
  ASSERT_EQ(walls.wall_count, 1);
  EXPECT_EQ(walls.walls[0].triangle, slope.triangle);
}

TEST(HoldingWalls, OneWallAloneAlwaysLeavesAPlace) {
  RandomStream random(7);
  for (int trial = 0; trial < 20000; ++trial) {
    const double size_m = std::pow(10, -6 + 8 * random.uniform());
    const ProxyWall wall{random_vector(random).normalized(), size_m * random.normal(), 0, 0};
    HoldingWalls walls;
    // What rounding does to coordinates of this size.
    ASSERT_TRUE(walls.project(size_m * random_vector(random), wall, 1e-14 * size_m)) << trial;
  }
}

}  // namespace
}  // namespace fingerpad::proxy_wall_test
