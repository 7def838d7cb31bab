// Ways between two free ticks: which cross a wall, and which only graze a corner.
#include "replay/pop_throughs.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "base/random_stream.hpp"
#include "support/shapes.hpp"
#include "support/worlds.hpp"

namespace fingerpad::pop_throughs_test {
namespace {

constexpr double degree = std::numbers::pi / 180;

bool counts(const std::shared_ptr<const World>& world, const Vec3& from, const Vec3& to) {
  PopThroughs pops(world, 0);
  for (const Vec3& at : {from, to}) {
    TickRecord row;
    row.p_WQ = at;
    pops.observe(row);
  }
  return pops.count() > 0;
}

/// A bar along y of 40 mm, its cross-section a triangle with this angle at the top, where z = 0.
TriangleSoup bar(double angle_rad) {
  const double h = 0.03, w = h * std::tan(angle_rad / 2), l = 0.02;
  TriangleSoup soup;
  soup.vertices_P.resize(3, 6);
  soup.vertices_P << 0, 0, -w, -w, w, w, -l, l, -l, l, -l, l, 0, 0, -h, -h, -h, -h;
  soup.triangles.resize(3, 8);
  soup.triangles << 0, 0, 0, 0, 2, 2, 0, 1, 1, 3, 4, 5, 3, 5, 2, 3, 3, 2, 5, 1, 5, 4, 4, 5;
  return soup;
}

TEST(PopThroughs, DoNotCountEdgesThatAreGrazed) {
  for (const double angle : {60 * degree, 90 * degree, 120 * degree}) {
    const auto world = test::world_of(bar(angle));
    for (const double depth_m : {1e-6, 1.3e-5, 1e-4, 1e-3}) {
      for (const double tilt : {-0.3, 0.0, 0.3}) {
        // Across the edge, so far below it, and on for two and a half times the chord at least.
        const double far_m = 6 * depth_m + 1e-4;
        const Vec3 middle(0, 1e-3, -depth_m), half(far_m, 0.4 * far_m, tilt * far_m);
        EXPECT_FALSE(counts(world, middle - half, middle + half))
            << angle / degree << " degrees, " << depth_m << " m deep, tilted by " << tilt;
      }
    }
  }
}

TEST(PopThroughs, DoNotCountCornersThatAreGrazed) {
  const auto world = test::world_of(test::box_soup(Vec3(0.02, 0.02, 0.02)));
  const Vec3 corner(0.01, 0.01, 0.01);
  RandomStream random(4);
  int clipped = 0;
  for (int k = 0; k < 300; ++k) {
    // Past the corner at right angles to its diagonal, a little below it.
    const Vec3 across =
        Vec3(random.normal(), random.normal(), random.normal()).cross(Vec3::Ones()).normalized();
    const double depth_m = 1e-6 * std::pow(10, 3 * random.uniform());
    const Vec3 middle = corner - depth_m * Vec3::Ones(), half = (5 * depth_m + 1e-5) * across;
    EXPECT_FALSE(counts(world, middle - half, middle + half)) << k << ", " << depth_m << " m deep";
    ++clipped;
  }
  EXPECT_EQ(clipped, 300);
}

TEST(PopThroughs, CountPlatesOfAnyThicknessCrossedAnywhere) {
  RandomStream random(9);
  for (const double thickness_m : {5e-5, 2e-4, 1e-3}) {
    const auto world = test::world_of(test::box_soup(Vec3(0.04, 0.04, thickness_m)));
    for (int k = 0; k < 200; ++k) {
      // 5 mm, a tick at 5 m/s, up to 30 degrees off the straight; every fourth close to the rim.
      const double at_m = k % 4 == 0 ? 0.02 - thickness_m : 0.016 * random.uniform();
      const Vec3 lean(k % 4 == 0 ? 0 : 0.5 * (2 * random.uniform() - 1), 0.5 * (2 * random.uniform() - 1),
                      -1);
      const Vec3 middle(at_m, 0.01 * random.uniform(), 0), half = 2.5e-3 * lean.normalized();
      EXPECT_TRUE(counts(world, middle - half, middle + half)) << thickness_m << " m thick, at " << at_m;
      EXPECT_TRUE(counts(world, middle + half, middle - half)) << "from behind";
    }
    // In at the face and out at the rim.
    const double t = thickness_m / 4;
    const Vec3 rim(0.02 - t, 1e-3, thickness_m / 2 - t), out(1e-3 + 3 * t, 0, -1e-3 - 3 * t);
    EXPECT_FALSE(counts(world, rim - out, rim + out)) << thickness_m;
  }
}

/// A ball is free at first, and at the end touches what its centre's way came through, pushed on by it.
bool counts_ball(const std::shared_ptr<const World>& world, const Vec3& from, const Vec3& to,
                 const Vec3& normal, double radius_m = 0) {
  PopThroughs pops(world, radius_m);
  TickRecord row;
  row.p_WQ = from;
  pops.observe(row);
  row.p_WQ = to;
  row.phase = Phase::stick;
  row.normal_W = normal;
  row.depth_m = 1e-3;
  row.walls = 1;
  row.surface = 0;
  pops.observe(row);
  return pops.count() > 0;
}

bool counts_ball(const std::shared_ptr<const World>& world, const Vec3& from, const Vec3& to) {
  return counts_ball(world, from, to, (to - from).normalized());
}

TEST(PopThroughs, DoNotCountABallThatIsLedRoundAnEdge) {
  const auto world = test::world_of(bar(60 * degree));
  const auto plate = test::world_of(test::box_soup(Vec3(0.04, 0.04, 0.001)));
  for (const double depth_m : {1e-5, 1e-4, 1e-3}) {
    const Vec3 middle(0, 1e-3, -depth_m), half(6 * depth_m + 1e-4, 0, 0);
    EXPECT_FALSE(counts_ball(world, middle - half, middle + half)) << depth_m;
    EXPECT_TRUE(counts_ball(plate, Vec3(0, 0, 2e-3), Vec3(depth_m, 0, -2e-3))) << depth_m;
    EXPECT_TRUE(counts_ball(plate, Vec3(0, 0, 2e-3), Vec3(depth_m, 0, -2e-4))) << "inside";
    EXPECT_TRUE(counts_ball(plate, Vec3(0, 0, 2e-4), Vec3(depth_m, 0, -2e-3))) << "from inside";
    EXPECT_TRUE(counts_ball(nullptr, Vec3(0, 0, 2e-3), Vec3(depth_m, 0, -2e-3))) << "nothing to ask";
  }
}

TEST(PopThroughs, CountABallThatGoesWhereAPointAloneGetsThrough) {
  const TriangleSoup slab = test::box_soup(Vec3(0.02, 0.04, 0.001));
  const auto world = test::world_of(
      test::joined(test::moved(slab, Vec3(0.0101, 0, 0)), test::moved(slab, Vec3(-0.0101, 0, 0))));
  const Vec3 from(0, 0, 0.008), to(0, 0, -0.004), down(0, 0, -1);
  EXPECT_TRUE(counts_ball(world, from, to, down, 0.005));
  EXPECT_FALSE(counts_ball(world, from, to, down, 0));
}

/// Deep in contact on two ticks, then free or pushed to the other side, at rest.
long pops_at_rest(Phase end, bool first_unsettled, bool second_unsettled) {
  PopThroughs pops(test::world_of(test::box_soup(Vec3(0.04, 0.04, 0.001))), 0.005);
  TickRecord row;
  row.p_WQ = Vec3(0, 0, 0.003);
  row.normal_W = Vec3::UnitZ();
  row.depth_m = 2e-3;
  row.phase = Phase::slip;
  for (const bool unsettled : {false, first_unsettled, second_unsettled}) {
    row.unsettled = unsettled;
    pops.observe(row);
  }
  row.unsettled = false;
  row.phase = end;
  row.normal_W = -Vec3::UnitZ();
  pops.observe(row);
  return pops.count();
}

TEST(PopThroughs, CountContactThatIsLostOrTurnsRoundAtRestButOfAProxyThatCatchesUp) {
  for (const Phase end : {Phase::free, Phase::slip}) {
    EXPECT_EQ(pops_at_rest(end, false, false), 1);
    EXPECT_EQ(pops_at_rest(end, false, true), 0);
    EXPECT_EQ(pops_at_rest(end, true, false), 0);
  }
}

// It ends in the bar, where a point that slides over the edge is held too, and on the same face.
TEST(PopThroughs, DoNotCountABallThatIsPushedAsThePointThatIsLedRound) {
  const double half_rad = 50 * degree, depth_m = 1e-3;
  const auto world = test::world_of(bar(2 * half_rad));
  const Vec3 from(-5 * depth_m, 1e-3, -depth_m), to(1.1 * depth_m, 1e-3, -depth_m);
  EXPECT_FALSE(counts_ball(world, from, to, Vec3(std::cos(half_rad), 0, std::sin(half_rad))));
  EXPECT_TRUE(counts_ball(world, from, to, Vec3(0.8, 0, -0.6))) << "out at the bottom";
}

TEST(PopThroughs, CountAPlateBehindAGrazedCornerOfAnotherPart) {
  auto world = std::make_shared<World>(*test::world_of(test::box_soup(Vec3(0.02, 0.02, 0.02))));
  world->surfaces.push_back(test::world_of(test::box_soup(Vec3(2e-4, 0.02, 0.02)))->surfaces[0]);
  world->surfaces[1].p_WP = Vec3(0.013, 0, 0.013);
  const Vec3 before(0.0085, 1e-3, 0.0113), between(0.0115, 1e-3, 0.0083);  // over the box's edge, 0.2 mm deep
  EXPECT_FALSE(counts(world, before, between));
  EXPECT_TRUE(counts(world, between, between + Vec3(0.004, 0, 0)));
  const Vec3 low(0.0085, 1e-3, 0.0101), beyond(0.0145, 1e-3, 0.0095);
  EXPECT_TRUE(counts(world, low, beyond)) << "over the edge and through the plate";
}

TEST(PopThroughs, CountABladeWhoseFlankWouldStillHoldTheFinger) {
  const auto world = test::world_of(bar(10 * degree));
  for (const double depth_m : {1e-5, 1e-4, 1e-3}) {
    const Vec3 middle(0, 1e-3, -depth_m), half(0.5 * depth_m, 0, 0);
    EXPECT_TRUE(counts(world, middle - half, middle + half)) << depth_m;
  }
}

TEST(PopThroughs, DoNotCountPushesOutOfAGrooveThatTurnAsTheFingerMoves) {
  // Two planes, 2.5 degrees to either side of z. One wall alone holds the finger above the groove's bottom,
  // both hold it below, where its push is straight to the bottom.
  const Vec3 left(-std::cos(2.5 * degree), 0, std::sin(2.5 * degree));
  const auto pops = [&left](const Vec3& from, const Vec3& to, double farther) {
    PopThroughs counted;
    TickRecord row;
    row.phase = Phase::slip;
    const auto feel = [&](const Vec3& p_W, const Vec3& push_m, int walls) {
      row.p_WQ = p_W;
      row.normal_W = push_m.normalized();
      row.depth_m = push_m.norm();
      row.contact_W = p_W + push_m;
      row.walls = walls;
      counted.observe(row);
    };
    feel(from, -left.dot(from) * left, 1);
    feel(to, -farther * to, 2);
    return counted.count();
  };
  const Vec3 over(4.5e-6, 0, 4.5e-6), under(-2.5e-6, 0, -2.5e-6), close_under(-0.5e-6, 0, -0.5e-6);
  EXPECT_EQ(pops(over, under, 1), 0);
  EXPECT_EQ(pops(over, close_under, 1), 0);
  EXPECT_EQ(pops(over, under, 3), 1) << "pushed farther than it moved";
}

TEST(PopThroughs, DoNotCountWhatRoundingAddsToAPushFromTheBottomOfAGroove) {
  // Both walls hold it at the bottom, but for what rounding does to that place: the push turns round it by
  // just as much as the finger moves.
  const Vec3 bottom(0.31, -0.17, 0.23);
  RandomStream random(3);
  PopThroughs pops;
  for (int k = 0; k < 1000; ++k) {
    TickRecord row;
    row.phase = Phase::slip;
    row.walls = 2;
    const double side_m = (k % 2 == 0 ? 1 : -1) * 1e-5 * (1 + random.uniform());
    row.p_WQ = bottom + Vec3(side_m, 0, -1e-6 * random.uniform());
    row.contact_W = bottom + 1e-14 * Vec3(random.uniform(), random.uniform(), random.uniform());
    row.depth_m = (row.contact_W - row.p_WQ).norm();
    row.normal_W = (row.contact_W - row.p_WQ) / row.depth_m;
    pops.observe(row);
  }
  EXPECT_EQ(pops.count(), 0);
}

TEST(PopThroughs, CountAnOpenSheetFromBothSides) {
  TriangleSoup sheet;
  sheet.vertices_P.resize(3, 4);
  sheet.vertices_P << -0.01, 0.01, 0.01, -0.01, -0.01, -0.01, 0.01, 0.01, 0, 0, 0, 0;
  sheet.triangles.resize(3, 2);
  sheet.triangles << 0, 0, 1, 2, 2, 3;
  const auto world = test::world_of(sheet);
  for (const double x_m : {0.0003, 0.005, 0.0099}) {
    const Vec3 above(x_m, 1e-3, 5e-4), below(x_m, 1e-3, -5e-4);
    EXPECT_TRUE(counts(world, above, below)) << x_m;
    EXPECT_TRUE(counts(world, below, above)) << x_m << ", from behind";
  }
  EXPECT_FALSE(counts(world, Vec3(0.012, 0, 5e-4), Vec3(0.012, 0, -5e-4))) << "beside it";
}

TEST(PopThroughs, CountAWayThatEndsInsideUnfelt) {
  const auto world = test::world_of(test::box_soup(Vec3(0.02, 0.02, 0.02)));
  EXPECT_TRUE(counts(world, Vec3(1e-3, 2e-3, 0.012), Vec3(1e-3, 2e-3, 0.008)));
}

}  // namespace
}  // namespace fingerpad::pop_throughs_test
