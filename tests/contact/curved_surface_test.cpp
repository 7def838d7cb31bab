#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "base/random_stream.hpp"
#include "contact/curved_patch.hpp"
#include "contact/profiles.hpp"
#include "contact/surface_point.hpp"
#include "contact/triangle_tree.hpp"
#include "support/effort.hpp"
#include "support/shapes.hpp"

namespace fingerpad::curved_surface_test {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();
constexpr double crease_rad = 30 * M_PI / 180;
constexpr Normals all_normals[] = {Normals::facet, Normals::smooth, Normals::curved};

TriangleTree tree_of(const TriangleSoup& soup) {
  TriangleTree tree(std::make_shared<const Part>(make_part(soup, crease_rad)));
  tree.prepare_curved();
  return tree;
}

SurfacePoint at(const TriangleTree& tree, const Vec3& p_P, Normals normals = Normals::curved) {
  return nearest_surface_point(tree, p_P, normals, -1, unbounded);
}

Vec3 random_point(RandomStream& random, double scale) {
  return Vec3(random.uniform() - 0.5, random.uniform() - 0.5, random.uniform() - 0.5) * (2 * scale);
}

/// The greatest errors of signed distance and normal.
struct Errors {
  double distance_m = 0, normal = 0;
};

Errors torus_errors(int n, Normals normals, double off_m) {
  const TriangleTree tree = tree_of(test::torus_soup(1, 0.4, n, n / 2));
  RandomStream random(5);
  Errors worst;
  for (int i = 0; i < test::samples(6000); ++i) {
    const double u = 2 * M_PI * random.uniform(), v = 2 * M_PI * random.uniform();
    const Vec3 outward(std::cos(u) * std::cos(v), std::sin(u) * std::cos(v), std::sin(v));
    const Vec3 ring(std::cos(u), std::sin(u), 0);
    const SurfacePoint s = at(tree, ring + (0.4 + off_m) * outward, normals);
    worst.distance_m = std::max(worst.distance_m, std::abs(s.signed_distance_m - off_m));
    worst.normal = std::max(worst.normal, (s.normal_P - outward).norm());
  }
  return worst;
}

TEST(CurvedSurface, OnATorusThePositionIsOfThirdOrderAndTheNormalOfSecond) {
  for (const double off_m : {-0.03, 0.0, 0.002, 0.05}) {
    const Errors coarse = torus_errors(64, Normals::curved, off_m);
    const Errors fine = torus_errors(128, Normals::curved, off_m);
    // 3 in theory, 3.0 to 3.2 as the next order's term fades; the normal's 2.0. Samples miss the worst place.
    EXPECT_GT(std::log2(coarse.distance_m / fine.distance_m), 2.85) << off_m;
    EXPECT_NEAR(std::log2(coarse.normal / fine.normal), 2, 0.2) << off_m;
    // Facets are of orders 2 and 1, and far off.
    const Errors facet = torus_errors(128, Normals::facet, off_m);
    EXPECT_LT(fine.distance_m, facet.distance_m / 100);
    EXPECT_LT(fine.normal, facet.normal / 15);
  }
}

/// The greatest change of the force's error from sample to sample along a rub over the filleted bar, per
/// force, and how far the answer is off.
struct FilletRub {
  double force_step = 0, distance_m = 0, distance_on_flat_m = 0;
};

FilletRub rub_over_fillet(int facets, int rows, Normals normals) {
  constexpr double depth_m = 0.05;
  const TriangleTree tree = tree_of(test::filleted_bar(facets, rows));
  FilletRub worst;
  Vec3 error_before = Vec3::Zero();
  constexpr int count = 20000;  // so many that a step is short beside a facet: what is measured are jumps
  for (int i = 0; i < count; ++i) {
    const double s = -2 + (4 + M_PI / 2) * i / count, angle = std::clamp(s, 0.0, M_PI / 2);
    const Vec3 outward(std::sin(angle), 0, std::cos(angle)), along(std::cos(angle), 0, -std::sin(angle));
    const Vec3 on = outward + (s - angle) * along + 0.37 * s * Vec3::UnitY();
    const SurfacePoint p = at(tree, on - depth_m * outward, normals);
    const Vec3 error = -p.signed_distance_m / depth_m * p.normal_P - outward;
    if (i > 0) worst.force_step = std::max(worst.force_step, (error - error_before).norm());
    error_before = error;
    const double off_m = std::abs(p.signed_distance_m + depth_m);
    worst.distance_m = std::max(worst.distance_m, off_m);
    if (s < -0.5 || s > M_PI / 2 + 0.5) worst.distance_on_flat_m = std::max(worst.distance_on_flat_m, off_m);
  }
  return worst;
}

TEST(CurvedSurface, OverAFilletTheForceStepsFallWithTheFacetsSize) {
  for (const int rows : {1, 7}) {
    std::array<FilletRub, 3> coarse, fine;
    for (std::size_t k = 0; k < std::size(all_normals); ++k) {
      coarse[k] = rub_over_fillet(8, rows, all_normals[k]);
      fine[k] = rub_over_fillet(16, rows, all_normals[k]);
    }
    const auto order = [](double a, double b) { return std::log2(a / b); };
    // Facets: by the turn from one to the next. Interpolated normals do not jump, but their slope does, by
    // the order of one: the distance's error does not fade. Patches: both do.
    EXPECT_NEAR(order(coarse[0].force_step, fine[0].force_step), 1, 0.1) << rows;
    EXPECT_NEAR(order(coarse[1].force_step, fine[1].force_step), 1, 0.1) << rows;
    EXPECT_GT(order(coarse[2].force_step, fine[2].force_step), 1.8) << rows;
    EXPECT_GT(order(coarse[2].distance_m, fine[2].distance_m), 2.9) << rows;
    EXPECT_LT(fine[1].force_step, fine[0].force_step / 10);
    EXPECT_LT(fine[2].force_step, fine[1].force_step / 10);
    for (const FilletRub& rub : fine) EXPECT_LE(rub.distance_on_flat_m, 1e-14);  // rounding of lengths of 10
  }
}

/// A flat plate of side 2 in any position, its inner vertices at random.
TriangleSoup random_plate(const Mat3& turn) {
  constexpr int cells = 9;
  TriangleSoup soup = test::square_soup(2, cells);
  RandomStream random(8);
  for (Eigen::Index i = 0; i < soup.vertices_P.cols(); ++i) {
    auto p = soup.vertices_P.col(i);
    if (p.cwiseAbs().maxCoeff() < 0.99) p += Vec3(random.uniform() - 0.5, random.uniform() - 0.5, 0) * 0.15;
  }
  soup.vertices_P = turn * soup.vertices_P;
  return soup;
}

TEST(CurvedSurface, ARubOverTheInternalEdgesOfAFlatFaceDoesNotMoveTheForce) {
  const Mat3 turn = Eigen::AngleAxisd(1.1, Vec3(1, -2, 0.5).normalized()).toRotationMatrix();
  const TriangleTree tree = tree_of(random_plate(turn));
  constexpr double finger_m = 0.01;
  for (const Normals normals : all_normals) {
    for (const double height_m : {-1e-2, -1e-5, 0.0, 1e-4, 9e-3}) {
      const Vec3 truth = (finger_m - height_m) * turn.col(2);
      for (int i = 0; i < test::samples(4000); ++i) {
        const double s = -0.8 + 1.6 * i / test::samples(4000);
        const SurfacePoint p = at(tree, turn * Vec3(s, 0.3 * s - 0.1, height_m), normals);
        const Vec3 force = (finger_m - p.signed_distance_m) * p.normal_P;
        ASSERT_LE((force - truth).norm(), 1e-9 * truth.norm()) << normals->name << " " << height_m;
      }
    }
  }
}

TEST(CurvedSurface, ABoxStaysTheBox) {
  const TriangleTree tree = tree_of(test::box_soup({2, 3, 4}));
  RandomStream random(1);
  for (int i = 0; i < test::samples(4000); ++i) {
    const Vec3 p = random_point(random, 3);
    const SurfacePoint facet = at(tree, p, Normals::facet), curved = at(tree, p);
    // The same bits: flat patches answer as their facets do.
    ASSERT_EQ(curved.signed_distance_m, facet.signed_distance_m);
    ASSERT_EQ(curved.point_P, facet.point_P);
    ASSERT_LE((curved.normal_P - facet.normal_P).norm(), 1e-15);
  }
}

TEST(CurvedSurface, ADrumsRimStaysSharpAndBecomesRound) {
  for (const bool fine : {false, true}) {
    const TriangleTree tree = tree_of(test::drum(fine ? 48 : 24));
    for (int i = 0; i < 500; ++i) {
      const double angle = 0.0126 * i;
      const Vec3 radial(std::cos(angle), std::sin(angle), 0);
      // In the rim's quadrant the normal turns with the finger; beside it, on either side, it is the face's.
      for (const double turn : {0.2, 0.8, 1.4}) {
        const Vec3 towards = std::cos(turn) * radial + std::sin(turn) * Vec3::UnitZ();
        const SurfacePoint p = at(tree, radial + Vec3::UnitZ() + 0.01 * towards);
        // Sides of twice 7.5 degrees: facets are off by 1 - cos, 8.6e-3, their patches by about .36 of the
        // angle's fourth power, 1.1e-4; seen over 0.01 that turns the normal by 0.01.
        ASSERT_LE((p.point_P - radial - Vec3::UnitZ()).norm(), fine ? 1e-5 : 1.5e-4);
        ASSERT_LE((p.normal_P - towards).norm(), fine ? 1e-3 : 1.5e-2);
      }
      ASSERT_LE((at(tree, 0.95 * radial + 0.999 * Vec3::UnitZ()).normal_P - Vec3::UnitZ()).norm(), 1e-14);
      ASSERT_LE((at(tree, 0.999 * radial + 0.95 * Vec3::UnitZ()).normal_P - radial).norm(), 1e-3);
    }
  }
}

TEST(CurvedSurface, IsContinuousAlongAPath) {
  const TriangleTree tree = tree_of(test::torus_soup(1, 0.4, 64, 32));
  for (const double off_m : {-0.001, 0.001}) {
    SurfacePoint before;
    constexpr double step = 2e-5;
    for (int i = 0; i < test::samples(40000); ++i) {
      const double u = 0.3 + step * i, v = 0.2 + 0.9 * step * i;
      const Vec3 outward(std::cos(u) * std::cos(v), std::sin(u) * std::cos(v), std::sin(v));
      const SurfacePoint p = at(tree, Vec3(std::cos(u), std::sin(u), 0) + (0.4 + off_m) * outward);
      if (i > 0) {
        // A step is at most 1.5 * 2e-5 m long. Where two patches meet, their normals are apart by h^2 = 1e-3
        // at most, which at a distance of 1e-3 moves the point by 1e-6, and the shown normal as the surface
        // turns: 2.5 rad/m.
        ASSERT_LE((p.point_P - before.point_P).norm(), 3e-5 + 2e-6);
        ASSERT_LE((p.normal_P - before.normal_P).norm(), 2.5 * (3e-5 + 2e-6));
        ASSERT_LE(std::abs(p.signed_distance_m - before.signed_distance_m), 3e-7);  // 1 percent of a step
      }
      before = p;
    }
  }
}

TEST(CurvedSurface, IsFoundFromDeepInsideARounding) {
  // Up to 97 % of the way to the middle, where the distance is hardly convex: the facets' own closest place
  // is off by up to a facet's turn.
  const TriangleTree tree = tree_of(test::sphere_soup(0.02, 3));
  RandomStream random(7);
  for (int i = 0; i < test::samples(400); ++i) {
    const Vec3 way =
        Vec3(random.uniform() - 0.5, random.uniform() - 0.5, random.uniform() - 0.5).normalized();
    for (const double left : {0.2, 0.03}) {
      const SurfacePoint found = at(tree, left * 0.02 * way);
      ASSERT_NEAR(found.signed_distance_m, (left - 1) * 0.02, 2e-6);
      // Patches' own normals are off by 2e-3, which turns the foot by the more, the less is left.
      ASSERT_LE((found.normal_P - way).norm(), 2e-3 / left);
    }
  }
}

TEST(CurvedSurface, NeitherSeedNorTableChangesABit) {
  const auto part = std::make_shared<const Part>(make_part(test::drum(31), crease_rad));
  const TriangleTree plain(part), prepared(part);
  prepared.prepare_curved();
  ASSERT_EQ(plain.curved_normals(), nullptr);
  ASSERT_NE(prepared.curved_normals(), nullptr);
  RandomStream random(3);
  for (int i = 0; i < test::samples(2000); ++i) {
    const Vec3 p = random_point(random, 1.5);
    const int seed = static_cast<int>(random.uniform() * part->triangle_count());
    const SurfacePoint a = nearest_surface_point(plain, p, Normals::curved, -1, unbounded);
    const SurfacePoint b = nearest_surface_point(prepared, p, Normals::curved, seed, unbounded);
    ASSERT_EQ(a.triangle, b.triangle);
    ASSERT_EQ(a.signed_distance_m, b.signed_distance_m);
    ASSERT_EQ(a.point_P, b.point_P);
    ASSERT_EQ(a.normal_P, b.normal_P);
  }
}

TEST(CurvedSurface, ReachCountsFromThePatchAlsoOutsideTheFacetsBox) {
  // The middle of a facet bounds the box at -x, at cos(pi/17) = 0.983, where the round drum goes on to 1.
  const TriangleTree tree = tree_of(test::drum(17));
  const Vec3 p(-0.995, 0, 0.1);
  EXPECT_GT(at(tree, p, Normals::facet).signed_distance_m, 0.01);
  EXPECT_EQ(nearest_surface_point(tree, p, Normals::facet, -1, 0).triangle, -1);
  // The patch's middle is off by .36 of the fourth power of pi/17.
  EXPECT_NEAR(nearest_surface_point(tree, p, Normals::curved, -1, 0).signed_distance_m, -0.005, 5e-4);
  EXPECT_EQ(nearest_surface_point(tree, {-1.02, 0, 0.1}, Normals::curved, -1, 0.01).triangle, -1);
}

TEST(CurvedSurface, MovingThePartMovesTheAnswerOnly) {
  const TriangleSoup soup = test::torus_soup(1, 0.4, 40, 20);
  const Vec3 offset(1e4, -2e4, 3e4);
  const TriangleTree here = tree_of(soup), there = tree_of(test::moved(soup, offset));
  RandomStream random(2);
  for (int i = 0; i < test::samples(2000); ++i) {
    const double u = 2 * M_PI * random.uniform(), v = 2 * M_PI * random.uniform();
    const Vec3 p = Vec3(std::cos(u), std::sin(u), 0) +
                   (0.3 + 0.2 * random.uniform()) *
                       Vec3(std::cos(u) * std::cos(v), std::sin(u) * std::cos(v), std::sin(v));
    const SurfacePoint a = at(here, p), b = at(there, p + offset);
    // The file's coordinates are rounded by 4e-12 there, edges are 0.1 long, so normals are by 1e-10, and at
    // a distance of 0.1 points by as much; near kinks a closest point may change sides.
    ASSERT_NEAR(a.signed_distance_m, b.signed_distance_m, 1e-10);
    if (a.triangle == b.triangle) {
      ASSERT_LE((a.normal_P - b.normal_P).norm(), 1e-7);
    }
  }
}

/// The largest distance of any patch of the part from its triangle.
double largest_deviation_m(const TriangleTree& tree) {
  double largest = 0;
  for (int t = 0; t < tree.part().triangle_count(); ++t) {
    largest = std::max(largest, curved_patch({tree.part(), tree.curved_normals()}, t).deviation_m);
  }
  return largest;
}

/// Finite, unit, never farther from the facets' answer than the patches are from the facets.
void expect_bounded(const TriangleTree& tree, int count, std::uint64_t seed) {
  const double deviation_m = largest_deviation_m(tree) + 1e-12 * tree.part().size_m();
  ASSERT_TRUE(std::isfinite(deviation_m));
  RandomStream random(seed);
  for (int i = 0; i < count; ++i) {
    const Vec3 off = random_point(random, tree.part().size_m() * std::pow(10.0, -i % 8));
    const int vertex = static_cast<int>(random.uniform() * static_cast<double>(tree.part().vertices.cols()));
    const Vec3 p = tree.part().centre_P + tree.part().vertices.col(vertex) + off;
    const SurfacePoint facet = at(tree, p, Normals::facet), curved = at(tree, p);
    ASSERT_NEAR(curved.normal_P.norm(), 1, 1e-12);
    ASSERT_TRUE(curved.point_P.allFinite());
    ASSERT_NEAR(std::abs(curved.signed_distance_m), std::abs(facet.signed_distance_m), deviation_m);
    if (std::abs(facet.signed_distance_m) > deviation_m) {
      ASSERT_EQ(curved.signed_distance_m < 0, facet.signed_distance_m < 0);
    }
  }
}

TEST(CurvedSurface, SliversBoundTheirPatches) {
  for (const double squeeze : {1e-2, 1e-4, 1e-7, 1e-10}) {
    TriangleSoup soup = test::torus_soup(1, 0.4, 40, 20);
    soup.vertices_P.row(2) *= squeeze;
    const TriangleTree flattened = tree_of(soup);
    ASSERT_NO_FATAL_FAILURE(expect_bounded(flattened, test::samples(1000), 1));
    TriangleSoup thin = test::drum(20);
    thin.vertices_P.row(2) *= squeeze;
    ASSERT_NO_FATAL_FAILURE(expect_bounded(tree_of(thin), test::samples(1000), 2));
  }
}

TEST(CurvedSurface, DamagedMeshesAreAnsweredWithNumbers) {
  RandomStream random(4);
  for (int round = 0; round < test::samples(60); ++round) {
    TriangleSoup soup = test::sphere_soup(1, 2);
    const auto any_triangle = [&] {
      return static_cast<Eigen::Index>(random.uniform() * static_cast<double>(soup.triangles.cols()));
    };
    for (int i = 0; i < 20; ++i) {
      const Eigen::Index t = any_triangle();
      switch (i % 4) {
        case 0:  // folded over, or a spike
          soup.vertices_P.col(soup.triangles(0, t)) = random_point(random, 2);
          break;
        case 1:  // wound the other way
          std::swap(soup.triangles(0, t), soup.triangles(1, t));
          break;
        case 2:  // more than two at an edge
          soup.triangles.col(t) = soup.triangles.col(any_triangle());
          soup.triangles(2, t) = soup.triangles(0, any_triangle());
          break;
        default:  // without area
          soup.vertices_P.col(soup.triangles(1, t)) = soup.vertices_P.col(soup.triangles(2, t));
      }
    }
    const TriangleTree tree = tree_of(soup);
    if (tree.part().triangle_count() == 0) continue;
    ASSERT_NO_FATAL_FAILURE(expect_bounded(tree, 200, static_cast<std::uint64_t>(round)));
  }
}

TEST(CurvedSurface, FarPointsAndNoNumbersAreHarmless) {
  const TriangleTree tree = tree_of(test::torus_soup(1, 0.4, 12, 8));
  for (const double far_m : {1e3, 1e9, 1e100, 1e300}) {
    const SurfacePoint p = at(tree, Vec3(far_m, 0.3, 0));
    EXPECT_NEAR(p.signed_distance_m / far_m, 1, 2e-3);
    EXPECT_TRUE(p.normal_P.allFinite());
  }
  EXPECT_EQ(at(tree, Vec3::Constant(std::nan(""))).triangle, -1);
  // The middle of the ring's tube: all round is equally near.
  EXPECT_NEAR(at(tree, Vec3(1, 0, 0)).signed_distance_m, -0.4, 0.05);
}

}  // namespace
}  // namespace fingerpad::curved_surface_test
