#include "touch/finger_room.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
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
      Looks looks(Looks::unlimited);
      const Vec3 at_W = stopped_on_line(world, {0, 0, -0.02}, Vec3::UnitZ(), 0.1, radius_m, 1e-6, looks);
      EXPECT_NEAR(at_W.z(), std::sqrt(radius_m * radius_m - 9e-6), 1e-5) << radius_m;
      EXPECT_GE(at_W.z(), std::sqrt(radius_m * radius_m - 9e-6)) << "it stands clear";
    }
    // There is room for this one.
    Looks looks(Looks::unlimited);
    EXPECT_EQ(stopped_on_line(world, {0, 0, -0.02}, Vec3::UnitZ(), 0.1, 0.002, 1e-6, looks),
              Vec3(0, 0, -0.02));
  }
}

TEST(FingerRoom, AFingerRestsOnTheRimOfASlotThatItsLineFallsThrough) {
  const World world = slot(true);
  const auto rim_at = [&](double x_m, double radius_m) {
    Looks looks(20000);
    return rim_on_line(world, {x_m, 0, 0.1}, {x_m, 0, -0.1}, radius_m, looks);
  };
  for (const double radius_m : {0.0035, 0.007, 0.02}) {
    for (const double x_m : {-0.0028, 0.0, 0.0015}) {
      SCOPED_TRACE(testing::Message() << radius_m << " m at " << x_m);
      const auto rim = rim_at(x_m, radius_m);
      ASSERT_TRUE(rim);
      const double nearer_m = 0.003 - std::abs(x_m);
      EXPECT_NEAR(rim->centre_W.z(), std::sqrt(radius_m * radius_m - nearer_m * nearer_m), 0.02 * radius_m);
      EXPECT_EQ(rim->centre_W.x(), x_m);
      EXPECT_EQ(rim->surface, 0);
    }
  }
  EXPECT_FALSE(rim_at(0, 0.002)) << "there is room for this one";
  EXPECT_FALSE(rim_at(0, 0)) << "and for a point";
  EXPECT_FALSE(rim_at(0.056, 0.007)) << "beside the part, by less than a radius: it slips off";
  EXPECT_FALSE(rim_at(0.2, 0.007)) << "far beside it";
}

/// That slot, as wide as asked for, over a floor so far below its mouth.
World slot_over_floor(double width_m, double floor_m) {
  const TriangleSoup block = test::moved(test::box_soup({0.05, 0.1, 0.005}), {0, 0, -0.0025});
  const double off_m = 0.025 + width_m / 2;
  const TriangleSoup bars =
      test::joined(test::moved(block, {off_m, 0, 0}), test::moved(block, {-off_m, 0, 0}));
  World world = *test::world_of(
      test::joined(bars, test::moved(test::box_soup({0.2, 0.2, 0.01}), {0, 0, -floor_m - 0.005})));
  world.verdicts.emplace_back().closed = true;
  return world;
}

// It went round the bars to the floor, which lies where nobody pointed.
TEST(FingerRoom, AFingerRestsOnTheRimOfASlotWhoseFloorIsSeen) {
  constexpr double radius_m = 0.007, floor_m = 0.04;
  const Vec3 spot_W(0.001, 0, -floor_m);
  for (const Vec3& eye_W : {Vec3(0, 0, 1), Vec3(-0.02, 0.4, 1), Vec3(0.03, -0.6, 1)}) {
    SCOPED_TRACE(testing::Message() << eye_W.transpose());
    const auto rim_with = [&](double width_m) {
      Looks looks(20000);
      return rim_before(slot_over_floor(width_m, floor_m), spot_W + 0.2 * eye_W, spot_W, Vec3::UnitZ(),
                        radius_m, looks);
    };
    for (const double width_m : {0.004, 0.008, 0.0135}) {
      const auto rim = rim_with(width_m);
      ASSERT_TRUE(rim) << width_m;
      EXPECT_LT((rim->centre_W - spot_W).cross(eye_W.normalized()).norm(), 1e-12) << "on the line";
      EXPECT_GT(rim->centre_W.z(), 0) << "over the mouth";
      const double to_bar_m = width_m / 2 - std::abs(rim->centre_W.x());
      EXPECT_NEAR(std::hypot(to_bar_m, rim->centre_W.z()), radius_m, 0.02 * radius_m) << "and on its edge";
    }
    EXPECT_FALSE(rim_with(0.0150)) << "there is room";
    EXPECT_FALSE(rim_with(0.03));
  }
  Looks few(10);
  EXPECT_FALSE(rim_before(slot_over_floor(0.008, floor_m), {0, 0, 0.2}, spot_W, Vec3::UnitZ(), radius_m, few))
      << "not known";
}

// Beside a rib on the floor: it went where the ball has room, which was round and under the floor.
TEST(FingerRoom, ARimStopsItTooWhereTheSpotThatIsSeenHasNoRoom) {
  constexpr double radius_m = 0.007, floor_m = 0.04, rib_m = 0.01;
  const World ribbed = *test::world_of(test::joined(
      test::joined(test::moved(test::box_soup({0.1, 0.1, 0.005}), {0.054, 0, -0.0025}),
                   test::moved(test::box_soup({0.1, 0.1, 0.005}), {-0.054, 0, -0.0025})),
      test::joined(test::moved(test::box_soup({0.2, 0.2, 0.01}), {0, 0, -floor_m - 0.005}),
                   test::moved(test::box_soup({0.01, 0.2, rib_m}), {0.008, 0, -floor_m + rib_m / 2}))));
  const Vec3 spot_W(0.001, 0, -floor_m);
  Looks looks(20000);
  const auto rim = rim_before(ribbed, spot_W + Vec3(0, 0, 0.2), spot_W, Vec3::UnitZ(), radius_m, looks);
  ASSERT_TRUE(rim);
  EXPECT_GT(rim->centre_W.z(), 0) << "over the mouth";
  // In a corner that is seen the ball is stopped by the corner itself.
  const World corner = *test::world_of(
      test::joined(test::moved(test::box_soup({0.2, 0.2, 0.01}), {0, 0, -floor_m - 0.005}),
                   test::moved(test::box_soup({0.01, 0.2, 0.03}), {0.008, 0, -floor_m + 0.015})));
  looks = Looks(20000);
  EXPECT_FALSE(rim_before(corner, spot_W + Vec3(-0.1, 0, 0.1), spot_W, Vec3::UnitZ(), radius_m, looks));
}

// What is seen beside an edge is pointed at, and there is a way round the edge.
TEST(FingerRoom, OneEdgeBeforeTheSpotHidesNothing) {
  constexpr double radius_m = 0.007;
  World world =
      *test::world_of(test::joined(test::moved(test::box_soup({0.05, 0.1, 0.005}), {-0.025, 0, 0.04}),
                                   test::moved(test::box_soup({0.2, 0.2, 0.01}), {0, 0, -0.005})));
  world.verdicts.emplace_back().closed = true;
  for (const double x_m : {-0.03, 0.001, 0.004}) {
    const Vec3 spot_W(x_m, 0, 0), beside_edge_W(0.001, 0, 0.04), above_W(0.002, 0, 0.2);
    const Vec3 from_W = x_m > 0 ? above_W : Vec3(spot_W + 5 * (beside_edge_W - spot_W));
    Looks looks(20000);
    EXPECT_FALSE(rim_before(world, from_W, spot_W, Vec3::UnitZ(), radius_m, looks)) << x_m;
  }
}

TEST(FingerRoom, InsideOfAClosedPartIsLessThanNoRoom) {
  for (const bool closed : {true, false}) {
    const World world = slot(closed);
    Looks looks(Looks::unlimited);
    const NearestSurface inside = nearest_surface(world, {0.02, 0, -0.004}, Normals::facet, 0.01, looks);
    EXPECT_EQ(inside.surface, 0);
    EXPECT_NEAR(inside.clear_m, closed ? -0.004 : 0.004, 1e-6);
    const NearestSurface above = nearest_surface(world, {0.02, 0, 0.004}, Normals::facet, 0.01, looks);
    EXPECT_NEAR(above.clear_m, 0.004, 1e-6);
    const NearestSurface far = nearest_surface(world, {0.02, 0, 0.04}, Normals::facet, 0.01, looks);
    EXPECT_EQ(far.surface, -1);
    EXPECT_EQ(far.clear_m, 0.01);
  }
}

// About the middle of a fine bowl all triangles are as near as any: searches without a bound would take a
// hundred ticks' time there.
TEST(FingerRoom, WhereTheLooksDoNotSufficeItIsStoppedClearOfEverything) {
  constexpr double bowl_m = 0.02, radius_m = 0.007, hardly_m = 1e-5;
  const World world = *test::world_of(test::sphere_soup(bowl_m, 5));
  const auto stopped_m = [&](long most_looks, Looks& looks) {
    looks = Looks(most_looks);
    return stopped_on_line(world, {0, 0, -bowl_m}, Vec3::UnitZ(), 0.9 * bowl_m, radius_m, hardly_m, looks)
        .z();
  };
  Looks looks(0);
  const double without_end_m = stopped_m(Looks::unlimited, looks);
  EXPECT_NEAR(without_end_m, radius_m - bowl_m, 1e-3 * bowl_m);
  const long needed = looks.spent();
  ASSERT_GT(needed, 2000);
  for (const long most : {0L, 10L, 100L, needed / 8, needed / 2}) {
    EXPECT_GE(stopped_m(most, looks), without_end_m) << most << " looks";
    // A look that is begun is ended.
    EXPECT_LT(looks.spent(), most + 500) << most << " looks";
  }
  EXPECT_EQ(stopped_m(2 * needed, looks), without_end_m);

  Looks few(10);
  EXPECT_FALSE(nearest_surface(world, Vec3::Zero(), Normals::facet, 1, few).is_sure);
  Looks enough(Looks::unlimited);
  EXPECT_TRUE(nearest_surface(world, Vec3::Zero(), Normals::facet, 1, enough).is_sure);
}

}  // namespace
}  // namespace fingerpad::finger_room_test
