#include "contact/closest_point.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/random_stream.hpp"
#include "contact/bare_part.hpp"
#include "support/brute_force.hpp"
#include "support/effort.hpp"

namespace fingerpad::closest_point_test {
namespace {

using test::bare_part;

Vec3 random_point(RandomStream& random, double scale) {
  return Vec3(random.uniform() - 0.5, random.uniform() - 0.5, random.uniform() - 0.5) * (2 * scale);
}

Part one_triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
  Points vertices(3, 3);
  vertices << a, b, c;
  IndexTriples triangles(3, 1);
  triangles << 0, 1, 2;
  return bare_part(vertices, triangles);
}

void expect_exact(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& q) {
  const Part part = one_triangle(a, b, c);
  const TrianglePoint found = closest_on_triangle(part, 0, q);
  double truth_m = 0;
  test::brute_closest_on(a, b, c, q, &truth_m);
  // Coordinates of a size L carry rounding of 1.1e-16 L each; some ten operations stand between them and a
  // distance.
  const double size = std::max({a.norm(), b.norm(), c.norm(), q.norm()});
  ASSERT_NEAR(std::sqrt(found.distance2_m2), truth_m, 4e-15 * size)
      << a.transpose() << " | " << b.transpose() << " | " << c.transpose() << " | " << q.transpose();
  ASSERT_NEAR((q - found.point).norm(), truth_m, 4e-15 * size);
  // The point lies on the triangle: its own nearest point there is itself.
  double off_m = 0;
  test::brute_closest_on(a, b, c, found.point, &off_m);
  ASSERT_LE(off_m, 4e-15 * size);
}

TEST(ClosestOnTriangle, EachRegionNamesItsFeature) {
  const Part part = one_triangle({0, 0, 0}, {4, 0, 0}, {0, 4, 0});
  const struct {
    Vec3 q;
    Feature feature;
    Vec3 point;
  } cases[] = {
      {{1, 1, 2}, Feature::face, {1, 1, 0}},     {{1, 1, -2}, Feature::face, {1, 1, 0}},
      {{2, -1, 1}, Feature::edge0, {2, 0, 0}},   {{3, 3, 1}, Feature::edge1, {2, 2, 0}},
      {{-1, 2, 0}, Feature::edge2, {0, 2, 0}},   {{-1, -1, 3}, Feature::vertex0, {0, 0, 0}},
      {{6, -1, 0}, Feature::vertex1, {4, 0, 0}}, {{-1, 7, 0}, Feature::vertex2, {0, 4, 0}},
      {{2, 0, 0}, Feature::edge0, {2, 0, 0}},    {{0, 0, 0}, Feature::vertex0, {0, 0, 0}},
  };
  for (const auto& c : cases) {
    const TrianglePoint found = closest_on_triangle(part, 0, c.q);
    EXPECT_EQ(found.feature, c.feature) << c.q.transpose();
    EXPECT_LE((found.point - c.point).norm(), 1e-15) << c.q.transpose();  // one rounding of a coordinate of 4
  }
}

TEST(ClosestOnTriangle, AgreesWithLongDoubleOnRandomTriangles) {
  RandomStream random(1);
  for (int i = 0; i < test::samples(50000); ++i) {
    const Vec3 a = random_point(random, 1), b = random_point(random, 1), c = random_point(random, 1);
    expect_exact(a, b, c, random_point(random, i % 2 == 0 ? 1 : 5));
    if (HasFatalFailure()) return;
  }
}

/// Needles (one short side) and caps (a corner almost on the opposite side), from aspect 1 to 1e13 and
/// beyond.
TEST(ClosestOnTriangle, SliversOfAnyAspectAreExact) {
  RandomStream random(2);
  for (int i = 0; i < test::samples(50000); ++i) {
    const double width = std::pow(10.0, -16 * random.uniform());
    const Vec3 a = random_point(random, 1), b = random_point(random, 1);
    const double along = i % 2 == 0 ? 0.0 : random.uniform();
    const Vec3 c = a + along * (b - a) + random_point(random, width);
    // Near the sliver, at its own width, and far off.
    const double away = std::pow(10.0, -16 * random.uniform());
    const Vec3 q = a + random.uniform() * (b - a) + random_point(random, i % 3 == 0 ? 2.0 : away);
    expect_exact(a, b, c, q);
    if (HasFatalFailure()) return;
  }
}

TEST(ClosestOnTriangle, TrianglesWithoutAreaAreSegmentsAndPoints) {
  const Vec3 o(0.1, 0.2, 0.3), x(1.1, 0.2, 0.3), m(0.35, 0.2, 0.3);
  RandomStream random(3);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 q = random_point(random, 2);
    expect_exact(o, x, m, q);
    expect_exact(o, o, x, q);
    expect_exact(x, o, o, q);
    expect_exact(o, o, o, q);
    if (HasFatalFailure()) return;
  }
  EXPECT_NE(closest_on_triangle(one_triangle(o, x, m), 0, {0.5, 1, 1}).feature, Feature::face);
  EXPECT_GE(closest_on_triangle(one_triangle(o, o, o), 0, {0.5, 1, 1}).feature, Feature::vertex0);
}

TEST(ClosestOnTriangle, WeightsRebuildThePoint) {
  RandomStream random(4);
  for (int i = 0; i < 20000; ++i) {
    const Vec3 a = random_point(random, 1), b = random_point(random, 1), c = random_point(random, 1);
    const TrianglePoint found = closest_on_triangle(one_triangle(a, b, c), 0, random_point(random, 1));
    const Vec3& w = found.barycentric;
    ASSERT_GE(w.minCoeff(), 0);
    ASSERT_NEAR(w.sum(), 1, 1e-15);  // three roundings
    // Weights are distances over heights; a height below 1e-3 is rare here and magnifies 1e-16 to 1e-13.
    ASSERT_LE((w[0] * a + w[1] * b + w[2] * c - found.point).norm(), 1e-12);
  }
}

TEST(ClosestOnTriangle, NeighboursGiveTheSameBitsOnTheirCommonEdge) {
  RandomStream random(5);
  for (int i = 0; i < 20000; ++i) {
    Points vertices(3, 4);
    for (int k = 0; k < 4; ++k) vertices.col(k) = random_point(random, 1);
    IndexTriples triangles(3, 2);
    triangles << 2, 1, 0, 2, 1, 3;  // columns (2, 0, 1) and (1, 2, 3): the edge 1-2 in both directions
    const Part part = bare_part(vertices, triangles);
    const Vec3 q = random_point(random, 3);
    const TrianglePoint one = closest_on_triangle(part, 0, q), other = closest_on_triangle(part, 1, q);
    const bool both = one.feature == Feature::edge2 && other.feature == Feature::edge0;
    if (both) {
      ASSERT_EQ(one.distance2_m2, other.distance2_m2);
      ASSERT_EQ(one.point, other.point);
    }
  }
}

TEST(ClosestOnTriangle, WindingAndOrderOfCornersMakeNoDifference) {
  RandomStream random(6);
  for (int i = 0; i < 5000; ++i) {
    Points vertices(3, 3);
    for (int k = 0; k < 3; ++k) vertices.col(k) = random_point(random, 1);
    IndexTriples triangles(3, 6);
    triangles << 0, 0, 1, 1, 2, 2,  //
        1, 2, 0, 2, 0, 1,           //
        2, 1, 2, 0, 1, 0;
    const Part part = bare_part(vertices, triangles);
    const Vec3 q = random_point(random, 2);
    const TrianglePoint first = closest_on_triangle(part, 0, q);
    for (int t = 1; t < 6; ++t) {
      const TrianglePoint found = closest_on_triangle(part, t, q);
      ASSERT_EQ(found.distance2_m2, first.distance2_m2);
      ASSERT_EQ(found.point, first.point);
    }
  }
}

}  // namespace
}  // namespace fingerpad::closest_point_test
