// Fingers that are pressed in deeper than their radius, taken round convex edges: held against a proxy, which
// must not be left behind.
#include "motion/sharp_edge.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "contact/fast_proxy.hpp"
#include "motion/finger_path.hpp"
#include "motion/surface_motion.hpp"
#include "support/shapes.hpp"

namespace fingerpad::sharp_edge_test {
namespace {

std::shared_ptr<const TriangleTree> tree_of(const TriangleSoup& soup) {
  return std::make_shared<const TriangleTree>(std::make_shared<const Part>(make_part(soup, 0.5)));
}

/// A blade along y: a triangle of base `thick_m` at x = 0 whose edge is at x = long_m, wound outwards.
TriangleSoup blade_soup(double long_m, double thick_m, double wide_m) {
  TriangleSoup soup = test::box_soup({long_m, wide_m, thick_m});
  for (Eigen::Index i = 0; i < soup.vertices_P.cols(); ++i) {
    if (soup.vertices_P(0, i) > 0) soup.vertices_P(2, i) = 0;
  }
  return soup;
}

/// A rod along x with flat ends, of so many flat sides, wound outwards.
TriangleSoup rod_soup(double radius_m, double long_m, int sides) {
  TriangleSoup soup;
  soup.vertices_P.resize(3, 2 * sides + 2);
  soup.triangles.resize(3, 4 * sides);
  soup.vertices_P.col(2 * sides) = Vec3(-long_m / 2, 0, 0);
  soup.vertices_P.col(2 * sides + 1) = Vec3(long_m / 2, 0, 0);
  for (int k = 0; k < sides; ++k) {
    const double angle = 2 * std::numbers::pi * k / sides;
    const Vec3 out(0, radius_m * std::cos(angle), radius_m * std::sin(angle));
    soup.vertices_P.col(k) = soup.vertices_P.col(2 * sides) + out;
    soup.vertices_P.col(sides + k) = soup.vertices_P.col(2 * sides + 1) + out;
    const int next = (k + 1) % sides;
    soup.triangles.col(4 * k) << k, sides + next, sides + k;
    soup.triangles.col(4 * k + 1) << k, next, sides + next;
    soup.triangles.col(4 * k + 2) << 2 * sides, next, k;
    soup.triangles.col(4 * k + 3) << 2 * sides + 1, sides + k, sides + next;
  }
  return soup;
}

struct Pressed {
  double most_m = 0;       ///< by which a proxy of the finger was left behind
  double whole_share = 0;  ///< of that, pressed in by over nine tenths of the depth
  double turn_rad = 0;     ///< the greatest between two normals on the way
};

/// What a replay does.
Pressed pressed(const std::shared_ptr<const TriangleTree>& tree, const Motion& motion, double radius_m,
                double depth_m, Normals normals, double rate_hz = 4000) {
  PlacedSurface surface;
  surface.tree = tree;
  surface.part = std::shared_ptr<const Part>(tree, &tree->part());
  Proxy proxy = fast_proxy({surface}, radius_m, normals);
  const FingerPath path(motion, rate_hz, Vec3::UnitX());
  Pressed found;
  int touching = 0, whole = 0;
  Vec3 first = Vec3::Zero();
  for (long k = 0; k < path.tick_count(); ++k) {
    const ProxyContact& contact = proxy.move(path.at(k).p_WQ, 1 / rate_hz);
    if (!contact.touching()) continue;
    if (touching++ == 0) first = contact.normal_W;
    found.most_m = std::max(found.most_m, contact.depth_m);
    found.turn_rad = std::max(found.turn_rad, std::acos(std::clamp(first.dot(contact.normal_W), -1.0, 1.0)));
    whole += contact.depth_m > 0.9 * depth_m ? 1 : 0;
  }
  found.whole_share = static_cast<double>(whole) / std::max(touching, 1);
  return found;
}

SurfaceMotion line_of(double size_m, std::int64_t place) {
  SurfaceMotion rub;
  rub.size_m = size_m;
  rub.place = place;
  return rub;
}

struct Case {
  const char* name;
  TriangleSoup soup;
  double radius_m, depth_m;
};

TEST(SharpEdge, IsRoundedByAFingerDeeperThanItsRadiusWithoutPressingDeeper) {
  const Case cases[] = {{"point on a box", test::box_soup({0.04, 0.03, 0.02}), 0, 0.001},
                        {"ball on a box", test::box_soup({0.04, 0.03, 0.02}), 0.001, 0.002},
                        {"point on a blade", blade_soup(0.04, 0.006, 0.04), 0, 0.0005}};
  for (const Case& one : cases) {
    SCOPED_TRACE(one.name);
    const auto tree = tree_of(one.soup);
    int turned = 0;
    for (std::int64_t place = 0; place < 12; ++place) {
      const LaidMotion laid = lay_on_surface(*tree, line_of(0.03, place), one.radius_m, one.depth_m);
      for (const Normals normals : {Normals::facet, Normals::smooth}) {
        const Pressed found = pressed(tree, laid.motion, one.radius_m, one.depth_m, normals);
        // As promised; a tick's shading may add a little to what the trial with facets found.
        EXPECT_LT(found.most_m, 1.12 * one.depth_m) << place;
        EXPECT_GT(found.whole_share, 0.5) << place << ": it presses as asked but for the edges";
        if (laid.edges > 0) {
          ++turned;
          EXPECT_GT(found.turn_rad, 1.2) << place << ": it goes on beyond the edge";
        } else {
          EXPECT_LT(found.turn_rad, 0.4) << place;
        }
      }
    }
    EXPECT_GT(turned, 6) << "too few of them met an edge";
  }
}

TEST(SharpEdge, IsRoundedAtTheTicksOfAnyRateAndSpeed) {
  const auto tree = tree_of(test::box_soup({0.04, 0.03, 0.02}));
  for (const double rate_hz : {250.0, 400.0, 1000.0, 3000.0}) {
    for (const double speed_m_per_s : {0.02, 0.3}) {
      SCOPED_TRACE(std::to_string(rate_hz) + " Hz, " + std::to_string(speed_m_per_s) + " m/s");
      int edges = 0;
      for (std::int64_t place = 0; place < 6; ++place) {
        SurfaceMotion rub = line_of(0.004, place);
        rub.shape = SurfaceMotion::Shape::circle;
        rub.turns = 4;
        rub.speed_m_per_s = speed_m_per_s;
        const LaidMotion laid = lay_on_surface(*tree, rub, 0, 0.001, rate_hz);
        edges += laid.edges;
        EXPECT_LE(pressed(tree, laid.motion, 0, 0.001, Normals::facet, rate_hz).most_m, 1.1 * 0.001) << place;
      }
      EXPECT_GT(edges, 0);
    }
  }
}

/// Whose centre stays outside, and whose proxy yet stays behind on the first face of a sharp edge.
TEST(SharpEdge, ABallPressedInByNearlyItsRadiusIsGivenUpWhereItWouldPressDeeper) {
  const auto tree = tree_of(test::box_soup({0.04, 0.03, 0.02}));
  int given_up = 0;
  for (const double depth_m : {0.0024, 0.0029, 0.003}) {
    for (std::int64_t place = 0; place < 6; ++place) {
      const LaidMotion laid = lay_on_surface(*tree, line_of(0.012, place), 0.003, depth_m);
      given_up += laid.tried - 1;
      EXPECT_LE(pressed(tree, laid.motion, 0.003, depth_m, Normals::facet, 1000).most_m, 1.1 * depth_m)
          << depth_m << " m at " << place;
    }
  }
  EXPECT_GT(given_up, 0);
}

/// Round a rod of many flat sides there is no sharp edge; but to a centre that goes round close to the axis a
/// proxy on one side never comes off it, and is pressed in by up to 1.3 times the depth.
TEST(SharpEdge, WhereThereIsNoneAPlaceIsGivenUpThatWouldPressDeeper) {
  const double depth_m = 0.001;
  const auto tree = tree_of(rod_soup(0.00115, 0.04, 24));
  int given_up = 0;
  for (std::int64_t place = 0; place < 4; ++place) {
    SurfaceMotion rub = line_of(0.006, place);
    rub.speed_m_per_s = 0.01;  // fine steps, of which none turns far
    const LaidMotion laid = lay_on_surface(*tree, rub, 0, depth_m);
    given_up += laid.tried - 1;
    EXPECT_LT(pressed(tree, laid.motion, 0, depth_m, Normals::facet).most_m, 1.12 * depth_m) << place;
  }
  EXPECT_GT(given_up, 0);
}

/// On a box the finger's centre is outside of the part, or nearest to the face from which it comes, or to
/// that to which it goes: never in the half where a proxy on the other face would be drawn on.
TEST(SharpEdge, IsGoneRoundByTheSideOfTheFace) {
  const double depth_m = 0.001, clearance_m = 0.0001;
  SurfaceWalker before, after;
  before.normal_P = Vec3::UnitZ();
  before.foot_P = Vec3(-1.05 * depth_m, 0, 0);
  before.p_P = before.foot_P - depth_m * before.normal_P;
  after.normal_P = Vec3::UnitX();
  after.foot_P = Vec3(0, 0.0001, -depth_m);
  after.p_P = after.foot_P - depth_m * after.normal_P;
  ASSERT_TRUE(turns_sharp_edge(before, after));
  EXPECT_TRUE(turns_sharp_edge(after, before));
  const auto way = way_round_edge(before, after, 0.0001, clearance_m);
  ASSERT_GT(way.size(), 20u);
  bool is_beyond = false;
  Vec3 last = before.p_P;
  for (const Vec3& at : way) {
    EXPECT_LE((at - last).norm(), 0.0001 + 1e-12);
    last = at;
    is_beyond |= at.x() > 0 && at.z() > 0;
    if (at.x() > 0 || at.z() > 0) continue;
    // A step's worth of what the walkers were off the fold.
    if (is_beyond)
      EXPECT_LT(-at.x(), -at.z() + 1e-9) << at.transpose();
    else
      EXPECT_LT(-at.z(), -at.x() + 1e-9) << at.transpose();
    EXPECT_GT(at.z(), -depth_m - 1e-9);
  }
  EXPECT_TRUE(is_beyond);
  EXPECT_LE((after.p_P - last).norm(), 0.0001 + 1e-12);
}

SurfaceWalker walker_under(const Vec3& foot_P, const Vec3& normal_P) {
  SurfaceWalker walker;
  walker.foot_P = foot_P;
  walker.normal_P = normal_P;
  walker.p_P = foot_P - 0.001 * normal_P;
  return walker;
}

TEST(SharpEdge, IsNoneInAHollowNorOnGentleGround) {
  const SurfaceWalker before = walker_under(Vec3(-0.001, 0, 0), Vec3::UnitZ());
  EXPECT_FALSE(turns_sharp_edge(before, walker_under(Vec3(0, 0, 0.001), -Vec3::UnitX()))) << "up the wall";
  EXPECT_FALSE(turns_sharp_edge(before, walker_under(before.foot_P, -Vec3::UnitX()))) << "about the corner";
  const double turn = 17 * std::numbers::pi / 180;
  const Vec3 beyond(0, 0, -0.00015);
  EXPECT_FALSE(turns_sharp_edge(before, walker_under(beyond, Vec3(std::sin(turn), 0, std::cos(turn)))));
  EXPECT_TRUE(
      turns_sharp_edge(before, walker_under(beyond, Vec3(std::sin(2 * turn), 0, std::cos(2 * turn)))));
}

}  // namespace
}  // namespace fingerpad::sharp_edge_test
