#include "contact/curved_patch.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "base/random_stream.hpp"
#include "contact/closest_point.hpp"
#include "contact/profiles.hpp"
#include "support/shapes.hpp"

namespace fingerpad::curved_patch_test {
namespace {

constexpr double crease_rad = 30 * M_PI / 180;

bool is_crease(const Part& part, int t, int k) {
  return (part.creases[static_cast<std::size_t>(t)] >> k & 1) != 0;
}

/// The weights of edge k's two ends, as corners of t, carried over to the triangle beyond.
Vec3 beyond(const Part& part, int t, const Vec3& barycentric, int other) {
  Vec3 there = Vec3::Zero();
  for (int k = 0; k < 3; ++k) {
    for (int c = 0; c < 3; ++c) {
      if (part.welded(c, other) == part.welded(k, t)) there[c] = barycentric[k];
    }
  }
  return there;
}

TEST(CurvedPatch, NeighboursMeetInOneCurveAndOverSmoothEdgesWithOneNormal) {
  for (const TriangleSoup& soup :
       {test::torus_soup(1, 0.4, 13, 7), test::filleted_bar(5, 3), test::drum(17)}) {
    const Part part = make_part(soup, crease_rad);
    for (int t = 0; t < part.triangle_count(); ++t) {
      const CurvedPatch patch = curved_patch({part}, t);
      for (int k = 0; k < 3; ++k) {
        const int other = part.neighbours(k, t);
        if (other < 0) continue;
        const CurvedPatch neighbour = curved_patch({part}, other);
        for (const double along : {0.0, 0.1, 0.5, 0.77}) {
          Vec3 b = Vec3::Zero();
          b[k] = 1 - along;
          b[(k + 1) % 3] = along;
          const Vec3 there = beyond(part, t, b, other);
          // Sums of ten terms of the part's size, in another order.
          ASSERT_LE((evaluate(patch, b).x - evaluate(neighbour, there).x).norm(), 1e-15 * part.size_m());
          if (is_crease(part, t, k)) continue;
          const Vec3 n = shown_normal(patch, b, part.facet_normals.col(t));
          ASSERT_LE((n - shown_normal(neighbour, there, part.facet_normals.col(other))).norm(), 4e-15);
        }
      }
    }
  }
}

TEST(CurvedPatch, HalfWayAlongAnEdgeTheShownNormalIsPerpendicularToItsCurve) {
  const Part part = make_part(test::torus_soup(1, 0.4, 24, 16), crease_rad);
  double by_the_mean = 0;  // what the mean of the ends would leave
  for (int t = 0; t < part.triangle_count(); ++t) {
    const CurvedPatch patch = curved_patch({part}, t);
    const Vec3 b(0.5, 0.5, 0);
    const Vec3 tangent = evaluate(patch, b).x1.normalized();
    ASSERT_NEAR(shown_normal(patch, b, part.facet_normals.col(t)).dot(tangent), 0, 4e-15);
    const Vec3 mean = (patch.corner_normal[0] + patch.corner_normal[1]).normalized();
    by_the_mean = std::max(by_the_mean, std::abs(mean.dot(tangent)));
  }
  EXPECT_GT(by_the_mean, 0.005);
}

TEST(CurvedPatch, DerivativesAreThoseOfDifferences) {
  const Part part = make_part(test::torus_soup(1, 0.4, 13, 7), crease_rad);
  const CurvedPatch patch = curved_patch({part}, 20);
  const Vec3 b(0.2, 0.5, 0.3), d1(-1, 1, 0), d2(-1, 0, 1);
  const PatchPoint p = evaluate(patch, b);
  const double h =
      1e-4;  // differences of a cubic are wrong by h^2 at most, of order 1e-8, and by 1e-16 / h^2
  const auto x = [&](const Vec3& at) { return evaluate(patch, at).x; };
  EXPECT_LE(((x(b + h * d1) - x(b - h * d1)) / (2 * h) - p.x1).norm(), 1e-7);
  EXPECT_LE(((x(b + h * d2) - x(b - h * d2)) / (2 * h) - p.x2).norm(), 1e-7);
  EXPECT_LE(((x(b + h * d1) - 2 * p.x + x(b - h * d1)) / (h * h) - p.x11).norm(), 1e-6);
  EXPECT_LE(((x(b + h * d2) - 2 * p.x + x(b - h * d2)) / (h * h) - p.x22).norm(), 1e-6);
  const Vec3 mixed =
      x(b + h * (d1 + d2)) - x(b + h * (d1 - d2)) - x(b - h * (d1 - d2)) + x(b - h * (d1 + d2));
  EXPECT_LE((mixed / (4 * h * h) - p.x12).norm(), 1e-6);
  EXPECT_GT(p.x11.norm(), 0.01);  // it is curved at all
}

TEST(CurvedPatch, TouchesTheCornersTangentPlanes) {
  const Part part = make_part(test::torus_soup(1, 0.4, 16, 8), crease_rad);
  for (int t = 0; t < part.triangle_count(); ++t) {
    const CurvedPatch patch = curved_patch({part}, t);
    for (int k = 0; k < 3; ++k) {
      const PatchPoint p = evaluate(patch, Vec3::Unit(k));
      ASSERT_LE((p.x - part.vertices.col(part.triangles(k, t))).norm(), 1e-15);
      // Only edges whose ends disagree about the bulge leave the tangent plane: by what they disagree, h^3.
      const Vec3 own = p.x1.cross(p.x2).normalized();
      ASSERT_GT(own.dot(patch.corner_normal[static_cast<std::size_t>(k)]), std::cos(0.1));
    }
  }
}

TEST(CurvedPatch, StaysWithinItsDeviationOfTheTriangle) {
  RandomStream random(1);
  for (const TriangleSoup& soup : {test::torus_soup(1, 0.4, 9, 6), test::filleted_bar(3, 1), test::drum(9)}) {
    const Part part = make_part(soup, crease_rad);
    for (int t = 0; t < part.triangle_count(); ++t) {
      const CurvedPatch patch = curved_patch({part}, t);
      // The greatest turn of a tangent off its chord bounds it too.
      ASSERT_LE(patch.deviation_m, patch.length_m / 5);
      for (int i = 0; i < 5; ++i) {
        Vec3 b(random.uniform(), random.uniform(), random.uniform());
        b /= b.sum();
        const Vec3 x = evaluate(patch, b).x;
        ASSERT_LE(std::sqrt(closest_on_triangle(part, t, x).distance2_m2),
                  patch.deviation_m + 1e-15 * part.size_m());
      }
    }
  }
}

TEST(CurvedPatch, ASliverBulgesLessThanItIsHigh) {
  // Slivers along the ring: edges 0.2 to 0.5 long, whose arcs rise by a thirtieth of that, are 0.01 apart.
  const Part part = make_part(test::torus_soup(1, 0.4, 16, 250), crease_rad);
  double most_bulge = 0;
  for (int t = 0; t < part.triangle_count(); ++t) {
    const CurvedPatch patch = curved_patch({part}, t);
    const Vec3 a = patch.control[1] - patch.control[0], b = patch.control[2] - patch.control[0];
    const double height_m = a.cross(b).norm() / patch.length_m;
    // Each edge's control points by half the height, the middle by half as much again as their mean.
    ASSERT_LE(patch.deviation_m, 0.75 * height_m * (1 + 1e-9));
    most_bulge = std::max(most_bulge, patch.deviation_m / height_m);
  }
  EXPECT_GT(most_bulge, 0.49);  // the bound was reached: they are bent enough to show it
}

TEST(CurvedPatch, AFlatFaceBesideAFilletStaysFlat) {
  const Part part = make_part(test::filleted_bar(8, 3), crease_rad);
  int flat = 0;
  for (int t = 0; t < part.triangle_count(); ++t) {
    const Vec3 n = part.facet_normals.col(t);
    if (std::abs(n.z() - 1) > 1e-9 && std::abs(n.x() - 1) > 1e-9) continue;
    ++flat;
    EXPECT_TRUE(curved_patch({part}, t).flat);
    for (int k = 0; k < 3; ++k) EXPECT_LE((curved_corner_normal(part, t, k) - n).norm(), 1e-9);
  }
  EXPECT_EQ(flat, 12);
}

TEST(CurvedPatch, ARoundWallBesideAFilletStaysStraightAlongItself) {
  const Part part = make_part(test::rounded_drum(24, 4), crease_rad);
  int on_wall = 0;
  for (int t = 0; t < part.triangle_count(); ++t) {
    if (std::abs(part.facet_normals(2, t)) > 1e-9) continue;
    ++on_wall;
    const CurvedPatch patch = curved_patch({part}, t);
    for (const Vec3& normal : patch.corner_normal) EXPECT_NEAR(normal.z(), 0, 1e-9);
    // Facets cut in by 2 (1 - cos 7.5 deg), 17e-3; edges that the fillets' facets tilted rose by 50e-3.
    for (const Vec3& b : {Vec3(0.5, 0.5, 0), Vec3(0, 0.5, 0.5), Vec3(0.5, 0, 0.5)}) {
      const Vec3 x = evaluate(patch, b).x + part.centre_P;
      EXPECT_NEAR(x.head<2>().norm(), 2, 1e-3) << x.transpose();
    }
  }
  EXPECT_EQ(on_wall, 48);
}

TEST(CurvedPatch, ANarrowStripOfARoundWallIsNoFillet) {
  // Strips of 24 and 6 degrees in turn: all edges turn by 15, and no strip is flat.
  const Part part = make_part(test::rounded_drum(24, 4, 0.8), crease_rad);
  int on_wall = 0;
  for (int t = 0; t < part.triangle_count(); ++t) {
    if (std::abs(part.facet_normals(2, t)) > 1e-9) continue;
    ++on_wall;
    for (int k = 0; k < 3; ++k) {
      const Vec3 n = curved_corner_normal(part, t, k);
      EXPECT_NEAR(n.z(), 0, 1e-9) << "the fillets at its ends are";
      EXPECT_GT((n - Vec3(part.facet_normals.col(t))).norm(), 0.02);
    }
  }
  EXPECT_EQ(on_wall, 48);
}

TEST(CurvedPatch, BothHalvesOfAQuadCountAsOneFacet) {
  // Whichever way they are split, a bar's strips on both sides of a corner weigh the same.
  const Part part = make_part(test::filleted_bar(8, 1), crease_rad);
  for (int t = 0; t < part.triangle_count(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const Vec3 p = part.vertices.col(part.triangles(k, t)) + part.centre_P;
      if (p.x() <= 0.01 || p.z() <= 0.01) continue;  // within the fillet, which is about the y axis
      const Vec3 n = curved_corner_normal(part, t, k);
      ASSERT_LE((n - Vec3(p.x(), 0, p.z()).normalized()).norm(), 1e-5);  // the angle is known to 1e-5
    }
  }
}

TEST(CurvedPatch, EdgesOfASphereAreArcs) {
  // Of up to 30 degrees: with control points under thirds of the chord they would rise 1.5e-3 too little.
  const Part part = make_part(test::sphere_soup(1, 2), M_PI);
  for (int t = 0; t < part.triangle_count(); ++t) {
    const CurvedPatch patch = curved_patch({part}, t);
    for (const Vec3& b : {Vec3(0.5, 0.5, 0), Vec3(0, 0.25, 0.75), Vec3(0.9, 0, 0.1)})
      ASSERT_NEAR((evaluate(patch, b).x + part.centre_P).norm(), 1, 1e-5);
  }
}

TEST(CurvedPatch, ARimIsRoundBesideSliversOfTheFlatEndToo) {
  const Part part = make_part(test::uneven_drum(), crease_rad);
  int on_rim = 0;
  for (int t = 0; t < part.triangle_count(); ++t) {
    for (int k = 0; k < 3; ++k) {
      if (!is_crease(part, t, k)) continue;
      Vec3 b = Vec3::Constant(0.5);
      b[(k + 2) % 3] = 0;
      ++on_rim;
      EXPECT_NEAR((evaluate(curved_patch({part}, t), b).x + part.centre_P).head<2>().norm(), 1, 1e-5);
    }
  }
  EXPECT_EQ(on_rim, 2 * 2 * 24);
}

}  // namespace
}  // namespace fingerpad::curved_patch_test
