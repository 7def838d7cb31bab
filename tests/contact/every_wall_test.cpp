#include "contact/every_wall.hpp"

#include <gtest/gtest.h>

#include "base/random_stream.hpp"

namespace fingerpad::every_wall_test {
namespace {

Vec3 random_vector(RandomStream& random) {
  return {random.normal(), random.normal(), random.normal()};
}

TEST(EveryWall, ComesToWhatTheProjectionOntoAnyOfTheWallsComesTo) {
  RandomStream random(5);
  std::array<int, 4> seen{};
  for (int trial = 0; trial < 20000; ++trial) {
    std::vector<ProxyWall> walls(1 + static_cast<std::size_t>(3 * random.uniform()));
    for (ProxyWall& wall : walls) {
      wall.normal = random_vector(random).normalized();
      wall.least_m = -random.uniform();
    }
    const Vec3 goal = 3 * random_vector(random);
    const double nearer_m = trial % 2 == 0 ? 0 : 0.1;
    const ProxyProjection every = EveryWall(walls).project(goal, walls);
    const ProxyProjection nearer = EveryWall(walls).with_walls_nearer(every, nearer_m);
    for (ProxyWall& wall : walls) wall.least_m -= nearer_m;
    const ProxyProjection p = project_onto_walls(goal, walls, 1e-12);
    const bool all_hold = p.wall_count == static_cast<int>(walls.size());
    ASSERT_EQ(nearer.found, all_hold);
    if (nearer_m == 0) {
      ASSERT_EQ(every.found, all_hold);
    }
    if (!all_hold) continue;
    ++seen[walls.size()];
    // Nearly parallel walls multiply a rounding.
    if (nearer_m == 0) {
      ASSERT_LT((every.z - p.z).norm(), 1e-12);
    }
    for (std::size_t k = 0; k < 3; ++k)
      ASSERT_NEAR(nearer.share_m[k], p.share_m[k], 1e-12 * p.z.norm() + 1e-9);
  }
  for (const int count : {1, 2, 3}) EXPECT_GT(seen[static_cast<std::size_t>(count)], 100);
}

}  // namespace
}  // namespace fingerpad::every_wall_test
