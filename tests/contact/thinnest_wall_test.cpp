#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "contact/part_measures.hpp"
#include "contact/triangle_tree.hpp"
#include "support/shapes.hpp"

namespace fingerpad::thinnest_wall_test {
namespace {

double thinnest_of(const TriangleSoup& soup) {
  const auto part = std::make_shared<const Part>(make_part(soup, 0.5));
  return told_wall_m(*part, measure_part(*part, TriangleTree(part)));
}

TEST(ThinnestWall, OfABoxIsItsShortestSide) {
  // A ray is measured in double: rounding of the box's longest side.
  EXPECT_NEAR(thinnest_of(test::box_soup({0.1, 0.2, 0.003})), 0.003, 1e-15);
  EXPECT_NEAR(thinnest_of(test::moved(test::box_soup({0.1, 0.2, 0.003}), {5, 6, 7})), 0.003, 1e-14);
  EXPECT_NEAR(thinnest_of(test::box_soup({100, 200, 0.003})), 0.003, 1e-12);
}

TEST(ThinnestWall, OfAHollowSphereIsTheGapBetweenItsShells) {
  const auto shell = test::joined(test::sphere_soup(1, 4), test::reversed(test::sphere_soup(0.9, 4)));
  // Facets of 0.09 lie within 0.0012 of the sphere.
  EXPECT_NEAR(thinnest_of(shell), 0.1, 0.0025);
}

TEST(ThinnestWall, OfASolidSphereIsItsDiameter) {
  EXPECT_NEAR(thinnest_of(test::sphere_soup(1, 4)), 2,
              0.012);  // the largest facets lie 0.006 inside the sphere
}

TEST(ThinnestWall, OfAWedgeIsNotItsSharpEdge) {
  // A prism over a triangle with a corner of 20 degrees: no two facets face each other within 30 degrees but
  // the long sides, which share the sharp edge's vertices, and the ends, 3 apart.
  const double half = 10 * M_PI / 180;
  TriangleSoup soup;
  soup.vertices_P.resize(3, 6);
  soup.vertices_P << 0, 1, 1, 0, 1, 1,  //
      0, -std::tan(half), std::tan(half), 0, -std::tan(half), std::tan(half), 0, 0, 0, 3, 3, 3;
  soup.triangles.resize(3, 8);
  soup.triangles << 0, 3, 0, 0, 1, 1, 2, 2,  //
      2, 4, 1, 4, 2, 5, 0, 3,                //
      1, 5, 4, 3, 5, 4, 3, 5;
  const double thinnest = thinnest_of(soup);
  EXPECT_GT(thinnest, 0.01);
  EXPECT_LE(thinnest, 3);
}

TEST(ThinnestWall, SlantedFacetsAreNoWalls) {
  // A regular tetrahedron cut so finely that a ray leaves through facets far from its start: none faces
  // another within 30 degrees (their normals turn by 109.5), so there is no wall.
  const Vec3 corners[4] = {{4, 4, 4}, {4, -4, -4}, {-4, 4, -4}, {-4, -4, 4}};
  constexpr int faces[4][3] = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
  constexpr int m = 4;  // binary fractions: the faces' common vertices are equal to the bit
  std::vector<Vec3> points;
  for (const auto& face : faces) {
    const Vec3 o = corners[face[0]], x = (corners[face[1]] - o) / m, y = (corners[face[2]] - o) / m;
    for (int i = 0; i < m; ++i) {
      for (int j = 0; i + j < m; ++j) {
        const Vec3 a = o + i * x + j * y;
        points.insert(points.end(), {a, a + x, a + y});
        if (i + j + 1 < m) points.insert(points.end(), {a + x, a + x + y, a + y});
      }
    }
  }
  TriangleSoup soup;
  soup.vertices_P.resize(3, static_cast<Eigen::Index>(points.size()));
  soup.triangles.resize(3, static_cast<Eigen::Index>(points.size() / 3));
  for (int i = 0; i < static_cast<int>(points.size()); ++i) {
    soup.vertices_P.col(i) = points[i];
    soup.triangles(i % 3, i / 3) = i;
  }
  EXPECT_EQ(thinnest_of(soup), std::numeric_limits<double>::infinity());
}

TEST(ThinnestWall, OfAnOpenPartIsNoNumber) {
  EXPECT_TRUE(std::isnan(thinnest_of(test::square_soup(1, 3))));
}

TEST(ThinnestWall, IsTheSameEachTime) {
  const auto shell =
      test::joined(test::torus_soup(1, 0.4, 60, 30), test::reversed(test::torus_soup(1, 0.33, 40, 20)));
  const double first = thinnest_of(shell);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(thinnest_of(shell), first);
}

}  // namespace
}  // namespace fingerpad::thinnest_wall_test
