#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <utility>

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

// A twentieth of a millimetre deep between walls of half a millimetre each: what little shading leaves of
// their sum goes through none to the other side. They were scaled by it, without a bound.
TEST(Walls, ThatFaceEachOtherPushByABoundedShareThatJumpsNowhere) {
  constexpr int steps = 40000;
  constexpr double share_m = 0.5e-3;
  Walls before;
  for (int k = 0; k <= steps; ++k) {
    const double rise = 0.1 * (2.0 * k / steps - 1);
    Contact contact = between_two({1, 0, rise}, {-1, 0, rise}, Vec3(0.02, 0.01, 1).normalized());
    contact.depth_m = 0.05e-3;
    Walls walls;
    find_walls(contact, walls);
    ASSERT_EQ(walls.count, 2) << rise;
    ASSERT_LT((push_of(walls) - contact.depth_m * contact.normal_W).norm(), 1e-15) << rise;
    if (walls.walls[0].triangle != 1) std::swap(walls.walls[0], walls.walls[1]);
    for (std::size_t i = 0; i < 2; ++i) {
      ASSERT_LE(walls.walls[i].share_m, 4 * share_m) << rise;
      if (k == 0) continue;
      ASSERT_LT((walls.walls[i].push_m - before.walls[i].push_m).norm(), 0.02 * share_m) << rise;
    }
    before = walls;
  }
}

TEST(Walls, OfHoldsThatAllPushByNothingAreOne) {
  Contact contact = between_two({1, 0, 0.5}, {-1, 0, 0.5}, Vec3::UnitZ());
  contact.holds[0].share_m = contact.holds[1].share_m = 0;
  Walls walls;
  find_walls(contact, walls);
  EXPECT_EQ(walls.count, 1);
}

}  // namespace
}  // namespace fingerpad::walls_test
