#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/random_stream.hpp"
#include "contact/proxies.hpp"
#include "contact/proxy_views.hpp"
#include "support/effort.hpp"
#include "support/shapes.hpp"

// What a proxy may do without a look around (slide, hop, roll, land), held against where it must come to
// stand.

namespace fingerpad::proxy_path_test {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();
constexpr double dt_s = 1e-3;
const int path_ticks = test::sanitized() ? 1000 : 10000;

struct Convex {
  const char* name;
  TriangleSoup soup;
  double radius_m;  ///< of the ball
  double depth_m;   ///< of its centre under the surface; negative above it
  Normals normals;
};

std::vector<Convex> convex_parts() {
  const TriangleSoup sphere = test::sphere_soup(0.1, 5), coarse = test::sphere_soup(0.1, 2),
                     box = test::box_soup(Vec3(0.2, 0.16, 0.1));
  return {
      {"ball over a sphere", sphere, 0.007, -0.0066, Normals::smooth},
      {"ball over a sphere, facet normals", sphere, 0.007, -0.0066, Normals::facet},
      {"point in a sphere", sphere, 0, 0.0002, Normals::smooth},
      {"ball over a coarse sphere", coarse, 0.004, -0.0035, Normals::facet},
      {"ball around a box's edges and corners", box, 0.005, -0.004, Normals::smooth},
      {"small ball around a box", box, 0.0003, -0.0002, Normals::facet},
  };
}

/// Something that goes on smoothly and comes everywhere, far from the part.
Vec3 wandering(int k) {
  const double around = 4e-4 * k, up = 1.4 * std::sin(1.3e-4 * k + 0.2);
  return Vec3(std::cos(up) * std::cos(around), std::cos(up) * std::sin(around), std::sin(up));
}

class ProxyPath : public EitherProxy {};
INSTANTIATE_TEST_SUITE_P(Kinds, ProxyPath, testing::ValuesIn(proxy_kinds), kind_name);

TEST_P(ProxyPath, NoWallThatTheBallIsFarFromHoldsItInThinAir) {
  Proxy proxy = make_proxy({surface_of(test::box_soup(Vec3(0.02, 0.02, 0.02)))}, 0.8e-3, Normals::facet);
  proxy.move(Vec3(5e-3, 0, -12e-3), dt_s);
  proxy.move(Vec3(5e-3, 0, -10.5e-3), dt_s);
  ASSERT_TRUE(proxy.state().contact.touching());
  // The straight way there meets the back of the face of x; along the bottom it comes by its edge.
  for (int k = 0; k < 1000; ++k) proxy.move(Vec3(11.516e-3, 8.967e-3, -8.793e-3), dt_s);
  EXPECT_FALSE(proxy.state().contact.touching());
}

TEST_P(ProxyPath, AroundAConvexPartTheBallStandsOverTheClosestPoint) {
  for (const Convex& convex : convex_parts()) {
    SCOPED_TRACE(convex.name);
    const PlacedSurface surface = surface_of(convex.soup);
    const Part& part = surface.tree->part();
    Proxy proxy = make_proxy({surface}, convex.radius_m, convex.normals);
    const double tolerance_m = 1e-9 * part.size_m();  // the skin is 2^-27 of half of it
    // A place that is nearer by less than 2^-34 of the size is not sought: beside a vertex a ball may be so
    // far off, and of two facets as near as each other a point may have either.
    const double unsought =
        convex.radius_m > 0 ? std::sqrt(2 * std::ldexp(part.size_m(), -34) / convex.radius_m) : 0.1;
    int touched = 0, on_edges = 0, off = 0;
    for (int k = 0; k < path_ticks; ++k) {
      const Vec3 towards = wandering(k);
      const ClosestTriangle under = surface.tree->closest(0.5 * towards, -1, unbounded);
      const Vec3 outwards = (0.5 * towards - under.at.point).normalized();
      const Vec3 goal = under.at.point - convex.depth_m * outwards;
      const ProxyContact& contact = proxy.move(part.centre_P + goal, dt_s);
      if (k == 0) continue;  // put there
      const ClosestTriangle closest = surface.tree->closest(goal, -1, unbounded);
      const double away_m = std::sqrt(closest.at.distance2_m2);
      // A point goes back to the nearest facet, a ball the rest of the way from where it is too near.
      const Vec3 direction = ((goal - closest.at.point) / away_m) * (convex.depth_m > 0 ? -1 : 1);
      const double depth_m = convex.depth_m > 0 ? away_m : convex.radius_m - away_m;
      ASSERT_TRUE(contact.touching() && contact.settled) << k;
      ASSERT_NEAR(contact.depth_m, depth_m, tolerance_m) << k;
      const double turned = (contact.direction_W - direction).norm();
      ASSERT_LT(turned, unsought) << k;
      ASSERT_LT((contact.point_W - part.centre_P - closest.at.point).norm(),
                2 * tolerance_m + std::max(convex.radius_m, depth_m) * turned)
          << k;
      off += turned > 1e-7 ? 1 : 0;
      ++touched;
      on_edges += closest.at.feature == Feature::face ? 0 : 1;
    }
    EXPECT_EQ(touched, path_ticks - 1);
    EXPECT_LE(off, path_ticks / 1000);
    if (convex.radius_m > 0) {
      EXPECT_GT(on_edges, path_ticks / 1000);
    }
  }
}

TEST_P(ProxyPath, SlidesAlongAValleyOverItsTrianglesEdges) {
  for (const double radius_m : {0.0, 0.003}) {
    // Two half planes at 90 degrees along y, four triangles.
    Proxy proxy =
        make_proxy({surface_of(test::roof_soup(0.05, -std::numbers::pi / 2))}, radius_m, Normals::smooth);
    for (int k = 0; k <= 400; ++k) proxy.move(Vec3(0.001, -0.02, 0.01 - 0.012 * k / 400), dt_s);
    for (int k = 0; k <= 4000; ++k) {
      const Vec3 goal(4e-4 * std::sin(0.03 * k), -0.02 + 1e-5 * k, -0.002);
      const ProxyContact& contact = proxy.move(goal, dt_s);
      ASSERT_EQ(contact.hold_count, 2) << k;
      const Vec3 place(0, goal.y(), std::numbers::sqrt2 * radius_m);
      ASSERT_LT((shown_place_W(contact, goal) - place).norm(), 1e-14) << k;  // rounding of 1e-1
      ASSERT_NEAR(contact.depth_m, (place - goal).norm(), 1e-14) << k;
      // Each wall takes its part of the push, which is straight up but for what the finger is beside.
      for (int h = 0; h < 2; ++h) {
        const ContactHold& hold = contact.holds[static_cast<std::size_t>(h)];
        ASSERT_NEAR(hold.share_m, hold.normal_W.dot(place - goal), 1e-14) << k;
        ASSERT_LT((hold.point_W - (place - radius_m * hold.normal_W)).norm(), 1e-8) << k;
      }
    }
  }
}

TEST_P(ProxyPath, LeavesAValleyUpItsWall) {
  Proxy proxy =
      make_proxy({surface_of(test::roof_soup(0.05, -std::numbers::pi / 2))}, 0.003, Normals::smooth);
  const double s = std::numbers::sqrt2;
  int walls[4] = {};
  for (int k = 0; k <= 4000; ++k) {
    // Down into the valley, along and up along the right wall, half a millimetre into it.
    const double up_m = 0.01 * std::sin(1e-3 * k);
    const Vec3 place(std::abs(up_m) / s, 1e-3 * std::cos(2e-3 * k), 0.003 * s + std::abs(up_m) / s);
    const Vec3 goal = place - 5e-4 * Vec3(-1, 0, 1) / s;
    const ProxyContact& contact = proxy.move(goal, dt_s);
    if (k < 10) continue;
    ++walls[contact.hold_count];
    ASSERT_NEAR(contact.depth_m, 5e-4, 2e-9) << k;
  }
  EXPECT_GT(walls[1], 3000);
}

TEST_P(ProxyPath, NoHopOverAGentleRidgeGoesThroughWhatStandsBeforeOrBehindIt) {
  // A thin plate across the way, 3 mm before or behind the ridge; the finger goes 1 to 8 mm a tick.
  for (const double plate_m : {-0.003, 0.003}) {
    const TriangleSoup plate = test::moved(test::box_soup(Vec3(2e-4, 0.05, 0.02)), Vec3(plate_m, 0, 0));
    const PlacedSurface surface = surface_of(test::joined(test::roof_soup(0.05, 0.2), plate));
    for (const double radius_m : {0.0, 1e-3}) {
      double farthest_m = -1;
      for (int step = 10; step <= 80; ++step) {
        Proxy proxy = make_proxy({surface}, radius_m, Normals::smooth);
        const double step_m = 1e-4 * step;
        const auto goal = [&](double x) { return Vec3(x, 0.001, radius_m - 5e-4 - 0.1 * std::abs(x)); };
        for (int k = 0; k < 20; ++k) proxy.move(goal(-0.02) + Vec3(0, 0, 0.01 - 5e-4 * k), dt_s);
        for (double x = -0.02; x < 0.02; x += step_m) {
          proxy.move(goal(x), dt_s);
          ASSERT_LT(proxy.ball_W().x(), plate_m - 1e-4 - radius_m + 1e-9) << step_m << " at " << x;
        }
        farthest_m = std::max(farthest_m, proxy.ball_W().x());
      }
      EXPECT_NEAR(farthest_m, plate_m - 1e-4 - radius_m, 1e-8) << "it came that far";
    }
  }
}

TEST(GapBound, OfOneLookHoldsEverywhere) {
  const Part part = make_part(test::torus_soup(1, 0.4, 12, 8), 0.5);
  RandomStream random(3);
  const auto place = [&random] { return Vec3(3 * random.normal(), 3 * random.normal(), random.normal()); };
  for (int t = 0; t < part.triangle_count(); ++t) {
    const Vec3 seen_from = place();
    const TriangleApproach seen = approach_triangle(part, t, seen_from);
    const GapBound bound(seen, seen_from, 0.1);
    EXPECT_NEAR(bound.least_gap_m(seen_from), seen.distance_m - 0.1, 1e-14);
    for (int k = 0; k < 20; ++k) {
      const Vec3 q = seen_from + 0.5 * place();
      EXPECT_LE(bound.least_gap_m(q), approach_triangle(part, t, q).distance_m - 0.1 + 1e-14);
      EXPECT_LT(GapBound().least_gap_m(q), 0) << "one that was not looked at may be anywhere";
    }
  }
}

}  // namespace
}  // namespace fingerpad::proxy_path_test
