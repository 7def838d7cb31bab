#include "fingerpad/part_surface.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <random>

#include "contact/surface_point.hpp"
#include "contact/triangle_tree.hpp"
#include "part/import.hpp"
#include "support/paths.hpp"
#include "support/refusal.hpp"

namespace fingerpad::part_surface_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

std::string bracket() {
  return (test::source_dir() / "scenes/parts/bracket_coarse.stl").string();
}

/// A triangle of area 1/2.
Points corners() {
  Points vertices(3, 3);
  vertices << 0, 1, 0, 0, 0, 1, 0, 0, 0;
  return vertices;
}
IndexTriples one_triangle(int a, int b, int c) {
  return Eigen::Vector3i(a, b, c);
}

TEST(PartSurface, AnswersWhatTheSearchTreeFinds) {
  const PartSurface part(bracket());
  const auto imported = import_touchable(bracket(), {});
  const TriangleTree tree(imported.part);
  ASSERT_EQ(part.triangle_count(), imported.part->triangle_count());
  ClosestPointPath path(part);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(-0.05, 0.15);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 p(place(random), place(random), place(random));
    const SurfacePoint expected =
        nearest_surface_point(tree, p, Normals::facet, -1, std::numeric_limits<double>::infinity());
    for (const ClosestPoint& closest : {part.closest(p), path.closest(p)}) {
      EXPECT_EQ(closest.point_m, expected.point_P);
      EXPECT_EQ(closest.normal, expected.pseudonormal_P);
      EXPECT_EQ(closest.signed_distance_m, expected.signed_distance_m);
      EXPECT_EQ(closest.triangle, imported.part->file_triangle[static_cast<std::size_t>(expected.triangle)]);
    }
  }
}

TEST(PartSurface, HasNoClosestPointToAPlaceThatIsNone) {
  const PartSurface part(corners(), one_triangle(0, 1, 2));
  const ClosestPoint closest = part.closest(Vec3(nan, 0, 0));
  EXPECT_EQ(closest.triangle, -1);
  EXPECT_TRUE(std::isinf(closest.signed_distance_m));
}

TEST(PartSurface, IsMadeOfAProgramsOwnTriangles) {
  const PartSurface part(corners(), one_triangle(0, 1, 2));
  const ClosestPoint closest = part.closest(Vec3(0.25, 0.25, -0.5));
  EXPECT_EQ(closest.point_m, Vec3(0.25, 0.25, 0));
  EXPECT_EQ(closest.normal, Vec3::UnitZ());
  EXPECT_EQ(closest.signed_distance_m, -0.5);
  EXPECT_EQ(part.lower_corner_m(), Vec3::Zero());
  EXPECT_EQ(part.upper_corner_m(), Vec3(1, 1, 0));
}

TEST(PartSurface, TakesTheUnitOfItsFile) {
  const double mm = PartSurface(bracket()).upper_corner_m().x();
  const double inches = PartSurface(bracket(), {.unit = "in"}).upper_corner_m().x();
  EXPECT_NEAR(inches, 25.4 * mm, 1e-12 * inches);
}

TEST(PartSurface, RefusesWhatCannotBeTouched) {
  using test::why_not;
  using testing::HasSubstr;
  EXPECT_THAT(why_not([] { PartSurface("nowhere.stl"); }), HasSubstr("nowhere.stl"));
  EXPECT_THAT(why_not([] { PartSurface(bracket(), {.unit = "furlong"}); }),
              HasSubstr("known: m, mm, cm, in"));
  EXPECT_THAT(why_not([] { PartSurface(bracket(), {.crease_deg = nan}); }), HasSubstr("crease_deg is nan"));
  EXPECT_THAT(why_not([] { PartSurface(corners(), one_triangle(0, 1, 3)); }), HasSubstr("vertex 3 of 3"));
  EXPECT_THAT(why_not([] { PartSurface(corners(), one_triangle(-1, 1, 2)); }), HasSubstr("vertex -1 of 3"));
  EXPECT_THAT(why_not([] { PartSurface(corners(), one_triangle(0, 1, 1)); }), HasSubstr("none has an area"));
  EXPECT_THAT(why_not([] { PartSurface(corners(), IndexTriples(3, 0)); }), HasSubstr("there are none"));
  Points broken = corners();
  broken(1, 2) = nan;
  EXPECT_THAT(why_not([&] { PartSurface(broken, one_triangle(0, 1, 2)); }), HasSubstr("vertex 2"));
}

TEST(PartSurface, TellsTheDamagesOfAMesh) {
  const std::string path = (test::scratch_dir() / "open.stl").string();
  std::ofstream(path)
      << "solid open\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
         "endloop\nendfacet\nendsolid open\n";
  EXPECT_THAT(PartSurface(path).warnings(), testing::Contains(testing::HasSubstr("open")));
  EXPECT_THAT(PartSurface(bracket()).warnings(), testing::IsEmpty());
}

}  // namespace
}  // namespace fingerpad::part_surface_test
