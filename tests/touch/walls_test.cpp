#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
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

// A rigid ball in a wedge drives its sides apart by 1/sin(half-angle) of what presses it in: a sliver's two
// sides, a tenth of a degree off each other, held it with 872 N where 1.7 N pressed, and friction with it.
TEST(Walls, OfAWedgePushAsItsAngleSaysUpToTenTimesWhatPresses) {
  constexpr double depth_m = 0.5e-3;
  double last_m = depth_m;
  for (double degrees = 90; degrees > 1e-3; degrees *= 0.999) {
    const double sine = std::sin(degrees * EIGEN_PI / 180), cosine = std::cos(degrees * EIGEN_PI / 180);
    Contact contact = between_two({cosine, 0, sine}, {-cosine, 0, sine}, Vec3::UnitZ());
    for (std::size_t i = 0; i < 2; ++i) contact.holds[i].share_m = depth_m / (2 * sine);
    Walls walls;
    find_walls(contact, walls);
    ASSERT_LT((push_of(walls) - depth_m * Vec3::UnitZ()).norm(), 1e-13) << degrees;
    double pushed_m = 0;
    for (const Wall& wall : walls) pushed_m += wall.share_m;
    if (sine >= 0.1 && walls.count == 2) {
      ASSERT_NEAR(pushed_m, depth_m / sine, 1e-12) << degrees;
    }
    ASSERT_LE(pushed_m, 11 * depth_m) << degrees;
    ASSERT_LT(std::abs(pushed_m - last_m), 0.002 * pushed_m) << degrees;
    last_m = pushed_m;
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
