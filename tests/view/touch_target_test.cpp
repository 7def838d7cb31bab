// Where the arrow keys lead the finger.
#include "view/touch_target.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/shapes.hpp"
#include "support/worlds.hpp"

namespace fingerpad::touch_target_test {
namespace {

constexpr double radius_m = 0.007, step_m = 0.001;
const Vec3 nowhere_W = Vec3::Constant(std::numeric_limits<double>::infinity());

/// Slats along y, 2 mm wide and 5 mm deep, their tops z = 0, every 5 mm from x = 0 on: between them one sees
/// through the part.
std::shared_ptr<const World> slats(int count) {
  TriangleSoup soup;
  for (int i = 0; i < count; ++i) {
    const auto slat = test::moved(test::box_soup({0.002, 0.1, 0.005}), {0.005 * i, 0, -0.0025});
    soup = i == 0 ? slat : test::joined(soup, slat);
  }
  World world = *test::world_of(soup);
  world.verdicts.emplace_back().closed = true;
  return std::make_shared<World>(world);
}

struct Walk {
  double most_step_m = 0, lowest_m = 1, end_x_m = 0;
};

/// Steps along +x, pressing.
Walk walk(TouchTarget& target, int steps) {
  Walk walk;
  target.press(true);
  for (int i = 0; i < steps; ++i) {
    const Vec3 before_W = target.sample().p_WQ;
    target.move_by({step_m, 0, 0}, Vec3::UnitZ(), nowhere_W);
    const Vec3 after_W = target.sample().p_WQ;
    walk.most_step_m = std::max(walk.most_step_m, (after_W - before_W).norm());
    walk.lowest_m = std::min(walk.lowest_m, after_W.z());
  }
  walk.end_x_m = target.sample().p_WQ.x();
  return walk;
}

TouchTarget over_slats() {
  Scene scene;
  scene.finger.radius_m = radius_m;
  return {slats(8), scene, 0.002, FingerSample{}};
}

// The spot went down the slats' walls and out at the back of the part, and the finger after it, all the way
// round.
TEST(TouchTarget, ArrowKeysRollTheFingerOverSlotsThatAreTooNarrowForIt) {
  TouchTarget target = over_slats();
  target.point_at({0, 0, 0}, Vec3::UnitZ(), 0);
  const Walk over = walk(target, 30);
  EXPECT_LE(over.most_step_m, 2 * step_m);
  EXPECT_GT(over.end_x_m, 0.025);
  // On two edges three millimetres apart.
  EXPECT_GT(over.lowest_m, std::sqrt(radius_m * radius_m - 0.0015 * 0.0015) - 1e-4);
}

TEST(TouchTarget, ArrowKeysBeginOnTheRimOfASlotThatIsPointedInto) {
  TouchTarget target = over_slats();
  target.point_at({0.004, 0, -0.003}, -Vec3::UnitX(), 0);
  target.press(true);
  target.move_by({step_m, 0, 0}, Vec3::UnitZ(), nowhere_W);
  const Vec3 first_W = target.sample().p_WQ;
  EXPECT_LT((first_W - Vec3(0.004, 0, radius_m)).norm(), 2 * step_m) << first_W.transpose();
  const Walk over = walk(target, 20);
  EXPECT_LE(over.most_step_m, 2 * step_m);
  EXPECT_GT(over.end_x_m, 0.02);
}

// What hangs over a slot stopped a finger that came down the eye's line: the key took it up there.
TEST(TouchTarget, ArrowKeysBeginAtAFingerThatIsAtItsSpotBesideWhatHangsOver) {
  World world = *slats(8);
  const auto bar = test::world_of(test::moved(test::box_soup({0.004, 0.1, 0.002}), {0.012, 0, 0.025}));
  world.surfaces.push_back(bar->surfaces[0]);
  world.verdicts.push_back(world.verdicts[0]);
  Scene scene;
  scene.finger.radius_m = radius_m;
  const Vec3 rests_W(0.004, 0, radius_m);
  for (const Vec3& finger_W : {rests_W, nowhere_W}) {
    TouchTarget target(std::make_shared<World>(world), scene, 0.002, FingerSample{});
    target.point_at({0.004, 0, -0.003}, -Vec3::UnitX(), 0);
    target.press(true);
    target.move_by({step_m, 0, 0}, Vec3::UnitZ(), finger_W);
    const double moved_m = (target.sample().p_WQ - rests_W).norm();
    if (finger_W == rests_W) {
      EXPECT_LT(moved_m, 2 * step_m);
    } else {
      EXPECT_GT(moved_m, 0.01) << "the bar is in the way of one that comes from afar";
    }
  }
}

// The last slat's outer edge: round it, down its side and round beneath.
TEST(TouchTarget, ArrowKeysRollTheFingerRoundAnEdge) {
  TouchTarget target = over_slats();
  target.point_at({0.0355, 0, 0}, Vec3::UnitZ(), 0);
  Walk round = walk(target, 20);
  EXPECT_LE(round.most_step_m, 2 * step_m);
  EXPECT_GT(round.end_x_m, 0.036 + 0.9 * radius_m);
}

}  // namespace
}  // namespace fingerpad::touch_target_test
