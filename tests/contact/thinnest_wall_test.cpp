#include "contact/thinnest_wall.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/shapes.hpp"

namespace fingerpad {
namespace {

double thinnest_of(const TriangleSoup& soup) {
  const auto part = std::make_shared<const Part>(make_part(soup, 0.5));
  return thinnest_wall_m(*part, TriangleTree(part));
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
}  // namespace fingerpad
