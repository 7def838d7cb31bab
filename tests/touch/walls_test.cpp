#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "touch/wall.hpp"

namespace fingerpad::walls_test {
namespace {

Vec3 push_of(const Walls& walls) {
  Vec3 push_m = Vec3::Zero();
  for (int i = 0; i < walls.count; ++i) push_m += walls.walls[static_cast<std::size_t>(i)].push_m;
  return push_m;
}

/// A finger half a millimetre deep between two walls of one part that all but face each other.
Contact between_two(const Vec3& first, const Vec3& second, const Vec3& normal) {
  Contact contact;
  contact.hold_count = 2;
  contact.holds[0] = {0, 1, Vec3::Zero(), first.normalized(), 0.5e-3};
  contact.holds[1] = {0, 2, Vec3::Zero(), second.normalized(), 0.5e-3};
  contact.depth_m = 0.5e-3;
  contact.normal_W = normal;
  return contact;
}

TEST(Walls, PushAltogetherAsTheContactDoes) {
  const Contact contact = between_two({1, 0, 0.5}, {-1, 0, 0.5}, Vec3(0.1, 0, 1).normalized());
  Walls walls;
  find_walls(contact, walls);
  EXPECT_EQ(walls.count, 2);
  EXPECT_LT((push_of(walls) - contact.depth_m * contact.normal_W).norm(), 1e-15);
}

// Shaded by normals that differ a little, two such walls are left with next to nothing, which may point
// anywhere: the finger was pulled in with all of its force.
TEST(Walls, PushSoToWhereTheirShadedNormalsAddUpToTheOppositeToo) {
  for (const double lean : {0.0, 1e-6, 0.01, 0.03, 0.06, 0.2}) {
    const Contact contact = between_two({1, 0, -0.05}, {-1, 0, -0.05}, Vec3(lean, 0, 1).normalized());
    Walls walls;
    find_walls(contact, walls);
    EXPECT_LT((push_of(walls) - contact.depth_m * contact.normal_W).norm(), 1e-12) << lean;
  }
  // All along one line, as those of a slot's two sides.
  const Contact slot = between_two({0, 0, -1}, {0, 0, 1}, Vec3::UnitZ());
  Walls walls;
  find_walls(slot, walls);
  EXPECT_LT((push_of(walls) - slot.depth_m * slot.normal_W).norm(), 1e-15);
}

}  // namespace
}  // namespace fingerpad::walls_test
