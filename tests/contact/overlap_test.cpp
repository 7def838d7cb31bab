#include "contact/overlap.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "contact/triangle_tree.hpp"
#include "support/shapes.hpp"

namespace fingerpad::overlap_test {
namespace {

PlacedSurface placed(const TriangleSoup& soup, const Vec3& p_WP) {
  PlacedSurface surface;
  surface.part = std::make_shared<const Part>(make_part(soup, 0.5));
  surface.tree = std::make_shared<const TriangleTree>(surface.part);
  surface.p_WP = p_WP;
  return surface;
}

PlacedSurface box_at(double x_m) {
  return placed(test::box_soup({0.1, 0.05, 0.05}), {x_m, 0, 0});
}

TEST(Overlap, IsToldOfPartsThatReachIntoOneAnother) {
  const std::vector<PlacedSurface> surfaces{box_at(0), box_at(0.09), box_at(0.5)};
  const auto found = overlaps(surfaces);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].one, 0u);
  EXPECT_EQ(found[0].other, 1u);
  EXPECT_NEAR(found[0].depth_m, 0.01, 1e-9) << "by the corners of either";
  EXPECT_NEAR(found[0].at_W.x(), 0.04, 0.0101);
}

TEST(Overlap, IsNotToldOfPartsThatTouchOrSinkInALittle) {
  EXPECT_TRUE(overlaps(std::vector{box_at(0), box_at(0.1)}).empty());
  EXPECT_TRUE(overlaps(std::vector{box_at(0), box_at(0.0985)}).empty()) << "1.5 mm of 100";
}

TEST(Overlap, OfPartsWithoutACornerInsideIsFoundAtPlacesOfTheirFacets) {
  // A plate through a rod's middle, wider than the rod.
  const std::vector<PlacedSurface> cross{placed(test::box_soup({0.3, 0.02, 0.02}), Vec3::Zero()),
                                         placed(test::box_soup({0.02, 0.3, 0.02}), Vec3::Zero())};
  const auto found = overlaps(cross);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_GT(found[0].depth_m, 0.006);
  EXPECT_LT(found[0].depth_m, 0.010001);
}

TEST(Overlap, OfPartsThatCoincideIsFoundBelowTheirSurfaces) {
  for (const double x_m : {0.0, 0.0005}) {
    const auto found = overlaps(std::vector{box_at(0), box_at(x_m)});
    ASSERT_EQ(found.size(), 1u);
    EXPECT_GT(found[0].depth_m, 0.02);
    EXPECT_LT(found[0].depth_m, 0.025 + 1e-9) << "half of what is thinnest";
  }
}

TEST(Overlap, BehindAPartTurnedInsideOutThereIsNone) {
  TriangleSoup inwards = test::box_soup({0.1, 0.05, 0.05});
  inwards.triangles.row(0).swap(inwards.triangles.row(1));
  EXPECT_TRUE(overlaps(std::vector{placed(inwards, Vec3::Zero()), box_at(0.2)}).empty());
}

TEST(Overlap, OfAPartWithAPlaneIsHowFarItLiesBehind) {
  PlacedSurface floor;
  floor.plane_point_W = {0, 0, -0.02};
  const auto found = overlaps(std::vector{box_at(0), floor});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].depth_m, 0.005, 1e-12);
  floor.plane_point_W.z() = -0.025;
  EXPECT_TRUE(overlaps(std::vector{box_at(0), floor}).empty()) << "it stands on it";
}

TEST(Overlap, BehindAnOpenPartThereIsNone) {
  EXPECT_TRUE(overlaps(std::vector{placed(test::square_soup(0.2, 4), Vec3::Zero()), box_at(0)}).size() == 1u)
      << "the square lies inside of the box";
  EXPECT_TRUE(overlaps(std::vector{placed(test::square_soup(0.2, 4), Vec3::Zero()),
                                   placed(test::square_soup(0.2, 4), {0, 0, -0.05})})
                  .empty());
}

}  // namespace
}  // namespace fingerpad::overlap_test
