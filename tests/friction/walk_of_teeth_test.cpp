#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/random_stream.hpp"
#include "friction/stick_walk.hpp"

namespace fingerpad::walk_of_teeth_test {
namespace {

PlaneVector random_vector(RandomStream& random, double length) {
  const double angle = 2 * std::numbers::pi * random.uniform();
  return {length * std::cos(angle), length * std::sin(angle)};
}

/// The plain walk of a finger that is slow throughout.
StickEnd walked(const PlaneVector& ratio, const PlaneVector& way, double low, double high, double speed,
                RandomStream& random) {
  const CircleSpring spring{1, 1000};
  const CoulombSlide slide{high, low, 0.1, true};
  StickWay ways;
  ways.ratio = ratio;
  ways.now = way;
  ways.velocity = {random_vector(random, speed), random_vector(random, speed)};
  return StickWalk(spring, slide, ways).run(Phase::stick, 0.9 * random.uniform());
}

TEST(WalkOfTeeth, IsTheWalkOfASlowFingerToTheBit) {
  RandomStream random(1);
  int without = 0, one = 0, several = 0, more_than_walked = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    const double high = 0.3, low = trial % 5 == 0 ? high : high * random.uniform();
    const PlaneVector ratio = random_vector(random, (trial % 7 == 0 ? 1.2 : 1.0) * high * random.uniform());
    const PlaneVector way = random_vector(random, std::pow(10, 5 * random.uniform() - 3));
    const StickEnd plain = walked(ratio, way, low, high, 0.099 * random.uniform(), random);
    const StickEnd fast = walk_of_teeth(ratio, way, low, high);
    ASSERT_EQ(fast.phase, plain.phase);
    ASSERT_EQ(fast.ratio.x(), plain.ratio.x()) << trial;
    ASSERT_EQ(fast.ratio.y(), plain.ratio.y()) << trial;
    ASSERT_EQ(fast.ruptures, plain.ruptures);
    ASSERT_EQ(fast.last_event, plain.last_event);
    ASSERT_EQ(fast.centre_moved, plain.centre_moved);
    ++(plain.ruptures == 0                  ? without
       : plain.ruptures == 1                ? one
       : plain.ruptures < most_stick_events ? several
                                            : more_than_walked);
  }
  EXPECT_GT(std::min({without, one, several, more_than_walked}), 300);
}

TEST(WalkOfTeeth, ARuptureIsWhereTheLimitIsReachedAndFallsAlongTheSpring) {
  // Stretched to 0.2 along x and pulled on by 0.15: at 2/3 of the way it passes 0.3 and falls to 0.1.
  const StickEnd end = walk_of_teeth({0.2, 0}, {0.15, 0}, 0.1, 0.3);
  EXPECT_EQ(end.ruptures, 1);
  EXPECT_NEAR(end.last_event, 2.0 / 3, 1e-15);
  EXPECT_NEAR(end.ratio.x(), 0.15, 1e-15);
  EXPECT_EQ(end.ratio.y(), 0);
}

// A normal force of 1e-15 N under a spring of fixed stiffness: a thousand million ruptures in a tick.
TEST(WalkOfTeeth, CountsNoTeethOfNextToNoForce) {
  const double low = 2, high = 3;
  EXPECT_EQ(many_teeth({low, 0}, {1000.5, 0}, low, high).count, 1000);
  EXPECT_EQ(many_teeth({low, 0}, {1e6 - 0.5, 0}, low, high).count, 999999);
  EXPECT_EQ(many_teeth({low, 0}, {1e6 + 1, 0}, low, high).count, 0);
  const Teeth none = many_teeth({low, 0}, {1e12, 0}, low, high);
  EXPECT_EQ(none.count, 0);
  EXPECT_GE(none.ratio.x(), low);
  EXPECT_LE(none.ratio.x(), high);
}

}  // namespace
}  // namespace fingerpad::walk_of_teeth_test
