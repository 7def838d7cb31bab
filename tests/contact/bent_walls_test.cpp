#include "contact/bent_walls.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "contact/proxies.hpp"
#include "contact/proxy_sight.hpp"
#include "contact/tree_trials.hpp"
#include "support/shapes.hpp"

namespace fingerpad::bent_walls_test {
namespace {

constexpr double radius_m = 3e-3, unbounded = std::numeric_limits<double>::infinity();

ProxySight sight_of(const TriangleSoup& soup) {
  return ProxySight(ProxyWorld({surface_of(soup)}, radius_m, Normals::facet));
}

ProxyStep step_from(ProxySight& sight, const Vec3& place_O, const Vec3& goal_O, const StepTerms& terms) {
  ProxyState state;
  state.place_O = place_O;
  state.goal_O = goal_O;
  return sight.step(state, terms);
}

/// Where a ball stands that touches a point from a direction.
Vec3 on(const ProxySight& sight, const Vec3& point, const Vec3& direction) {
  return point + sight.world().clearance_m() * direction.normalized();
}

double off_line(const Vec3& place, const Vec3& from, const Vec3& towards) {
  return (place - from).normalized().cross((towards - from).normalized()).norm();
}

TEST(BentWalls, OverACornerOneStepEndsOnTheLineThroughTheFinger) {
  ProxySight sight = sight_of(test::box_soup(Vec3(0.02, 0.02, 0.02)));
  const Vec3 corner(0.01, 0.01, 0.01);
  const Vec3 place = on(sight, corner, Vec3(1, 1.2, 0.9)), goal = corner + 1e-3 * Vec3(1, 0.9, 1.1);
  const ProxyStep flat = step_from(sight, place, goal, {unbounded});
  ASSERT_EQ(flat.wall_count, 1);
  EXPECT_NE(flat.end, StepEnd::bent);
  EXPECT_GT(off_line(place + flat.z, corner, goal), 0.03);
  const ProxyStep bent = step_from(sight, place, goal, {unbounded, unbounded});
  EXPECT_EQ(bent.end, StepEnd::bent);
  // Rounding, of a share of two thirds.
  EXPECT_LT(off_line(place + bent.z, corner, goal), 1e-9);
  EXPECT_NEAR(bent.walls[0].normal.dot(bent.z - flat.z), 0, 1e-15) << "it goes on within the plane";
}

TEST(BentWalls, AnEdgeBendsAcrossAndAFaceNowhere) {
  ProxySight sight = sight_of(test::box_soup(Vec3(0.02, 0.02, 0.02)));
  const Vec3 edge(0, 0.01, 0.01);
  const Vec3 place = on(sight, edge, Vec3(0, 1, 0.7)), goal = edge + Vec3(4e-4, 1e-3, 1.1e-3);
  const ProxyStep step = step_from(sight, place, goal, {unbounded, unbounded});
  EXPECT_EQ(step.end, StepEnd::bent);
  const Vec3 foot(step.z.x(), edge.y(), edge.z());
  EXPECT_NEAR(step.z.x(), 4e-4, 1e-12) << "along the edge as if it were flat";
  EXPECT_LT(off_line(place + step.z, foot, Vec3(step.z.x(), goal.y(), goal.z())), 1e-9);

  const Vec3 over = on(sight, Vec3(0, 0, 0.01), Vec3::UnitZ());
  const ProxyStep slide = step_from(sight, over, Vec3(1e-3, 2e-3, 0.011), {unbounded, unbounded});
  ASSERT_EQ(slide.wall_count, 1);
  EXPECT_NE(slide.end, StepEnd::bent);
  EXPECT_EQ(way_along_bend(sight.world(), slide), Vec3::Zero());
}

/// Two boxes whose corners a ball can lie on at once, in a gap of half its size.
TriangleSoup corners_beside_each_other() {
  const double gap_m = radius_m / 2;
  const Mat3 upright = Eigen::AngleAxisd(M_PI / 4, Vec3::UnitX()).toRotationMatrix();
  TriangleSoup left = test::box_soup(Vec3(0.02, 0.02, 0.02));
  left.vertices_P = upright * left.vertices_P;
  const double top_m = left.vertices_P.row(2).maxCoeff();
  TriangleSoup right = test::moved(left, Vec3(0.01 + gap_m, 0, -top_m));
  return test::joined(test::moved(left, Vec3(-0.01 - gap_m, 0, -top_m)), right);
}

/// How many steps until they are no longer than the tolerance.
int steps_to_rest(ProxySight& sight, Vec3& place, const Vec3& goal, double bent_m) {
  for (int k = 1; k <= 100; ++k) {
    const ProxyStep step = step_from(sight, place, goal, {unbounded, k > 1 ? bent_m : 0});
    place += step.z;
    if (step.z.norm() <= sight.world().tolerance_m()) return k;
  }
  return 101;
}

TEST(BentWalls, ABallOnTwoCornersComesToRestInAFewSteps) {
  ProxySight sight = sight_of(corners_beside_each_other());
  const Vec3 goal = Vec3(1e-4, 2e-4, 1e-3) - sight.world().p_WO();
  Vec3 flat_place = Vec3(0, 3e-4, 4e-3) - sight.world().p_WO(), bent_place = flat_place;
  EXPECT_GT(steps_to_rest(sight, flat_place, goal, 0), 15);
  EXPECT_LE(steps_to_rest(sight, bent_place, goal, unbounded), 7);
  EXPECT_LT((flat_place - bent_place).norm(), 1e-9) << "it is the same place";
}

TEST(BentWalls, NoStepLeadsAwayFromTheFinger) {
  ProxySight sight = sight_of(test::box_soup(Vec3(0.02, 0.02, 0.02)));
  const Vec3 corner(0.01, 0.01, 0.01);
  RandomStream random(5);
  int bent = 0;
  for (int k = 0; k < 20000; ++k) {
    const Vec3 place = on(sight, corner, test::random_point(random, 1).cwiseAbs()),
               goal = corner + test::random_point(random, 5e-3);
    const ProxyStep step = step_from(sight, place, goal, {unbounded, unbounded});
    EXPECT_LE((place + step.z - goal).norm(), (place - goal).norm()) << k;
    bent += step.end == StepEnd::bent ? 1 : 0;
  }
  EXPECT_GT(bent, 100);
}

TEST(BentWalls, TheWayIsNoLongerThanAskedForAndFreeOfAllElse) {
  const TriangleSoup box = test::box_soup(Vec3(0.02, 0.02, 0.02));
  const Vec3 corner(0.01, 0.01, 0.01), goal = corner + 1e-3 * Vec3(1, 0.9, 1.1);
  ProxySight sight = sight_of(box);
  const Vec3 place = on(sight, corner, Vec3(1, 1.2, 0.9));
  const double flat_m = step_from(sight, place, goal, {unbounded}).z.norm();
  const ProxyStep cut = step_from(sight, place, goal, {unbounded, 1.1 * flat_m});
  EXPECT_NE(cut.end, StepEnd::bent) << "not to its end";
  EXPECT_GT(cut.z.norm(), 1.05 * flat_m);
  EXPECT_LE(cut.z.norm(), 1.1 * flat_m * (1 + 1e-9));

  // A wall stands in the way, behind where the step ends.
  const Vec3 way = step_from(sight, place, goal, {unbounded, unbounded}).z;
  const double beyond_m = flat_m + (way.norm() - flat_m) / 2;
  ProxySight walled(ProxyWorld(
      {surface_of(box),
       plane_of(place + beyond_m * way.normalized() - sight.world().clearance_m() * -way.normalized(), -way)},
      radius_m, Normals::facet));
  const ProxyStep stopped = step_from(walled, place, goal, {unbounded, unbounded});
  EXPECT_EQ(stopped.wall_count, 1);
  EXPECT_NE(stopped.end, StepEnd::bent);
  EXPECT_NEAR(stopped.z.norm(), flat_m, 1e-12);
}

}  // namespace
}  // namespace fingerpad::bent_walls_test
