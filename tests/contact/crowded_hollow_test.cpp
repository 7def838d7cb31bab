#include "contact/crowded_hollow.hpp"

#include <gtest/gtest.h>

#include "contact/part_measures.hpp"
#include "contact/triangle_tree.hpp"
#include "support/shapes.hpp"

// Hollows are balls turned inside out: 8 * 4^n triangles.

namespace fingerpad::crowded_hollow_test {
namespace {

constexpr double ball_m = 0.007;

CrowdedHollow crowded(double hollow_m, int subdivisions, double radius_m) {
  TriangleSoup soup = test::sphere_soup(hollow_m, subdivisions);
  soup.triangles.row(1).swap(soup.triangles.row(2));
  const auto part = std::make_shared<const Part>(make_part(soup, 0.5));
  const TriangleTree tree(part);
  return most_crowded_hollow(tree, measure_part(*part, tree).places, radius_m);
}

TEST(CrowdedHollow, IsTooMuchWhereABallFitsAFineOne) {
  const CrowdedHollow fine = crowded(0.0075, 6, ball_m);
  EXPECT_TRUE(fine.is_too_much()) << "its proxy is off by nine tenths of the force there";
  EXPECT_NEAR(fine.radius_m, 0.0075, 0.0005);
}

TEST(CrowdedHollow, IsNotWhereItIsCoarseOrTheBallHasRoomOrIsAPoint) {
  EXPECT_FALSE(crowded(0.0075, 4, ball_m).is_too_much());
  EXPECT_FALSE(crowded(0.008, 6, ball_m).is_too_much()) << "the proxy keeps up in it";
  EXPECT_EQ(crowded(0.0075, 6, 0).facets, 0);
  EXPECT_EQ(crowded(0.0075, 6, 0.002).facets, 0);
}

}  // namespace
}  // namespace fingerpad::crowded_hollow_test
