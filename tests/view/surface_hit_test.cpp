// What a line of sight meets first, against a plain loop over all facets; and that the first line builds
// nothing.
#include "view/surface_hit.hpp"

#include <gtest/gtest.h>
#include <malloc.h>

#include <Eigen/Geometry>
#include <cmath>

#include "base/random_stream.hpp"
#include "support/worlds.hpp"
#include "view/rub.hpp"
#include "view/screen.hpp"
#include "view/stage_vtk.hpp"

namespace fingerpad::surface_hit_test {
namespace {

/// Where the line meets the nearest facet, from either side (Moeller & Trumbore 1997); infinite: nowhere.
double plain_along(const Surface& surface, const Vec3& a_W, const Vec3& b_W) {
  double nearest = HUGE_VAL;
  const Part& part = *surface.part;
  for (int t = 0; t < part.triangle_count(); ++t) {
    const auto corner = [&](int k) -> Vec3 {
      return surface.p_WP + surface.R_WP * (part.centre_P + part.vertices.col(part.triangles(k, t)));
    };
    const Vec3 way = b_W - a_W, ab = corner(1) - corner(0), ac = corner(2) - corner(0);
    const Vec3 from = a_W - corner(0), p = way.cross(ac), q = from.cross(ab);
    const double determinant = p.dot(ab);
    const double u = from.dot(p) / determinant, v = way.dot(q) / determinant;
    const double along = ac.dot(q) / determinant;
    if (u >= 0 && v >= 0 && u + v <= 1 && along >= 0 && along <= 1) nearest = std::min(nearest, along);
  }
  return nearest;
}

Vec3 anywhere(RandomStream& random, double scale) {
  return (Vec3(random.uniform(), random.uniform(), random.uniform()) - Vec3::Constant(0.5)) * 2 * scale;
}

/// Lines through a part in some pose. @returns how many met it from behind
int expect_plain_hits(const TriangleSoup& soup) {
  Surface surface = test::world_of(soup)->surfaces[0];
  surface.p_WP = Vec3(0.3, -2, 1);
  surface.R_WP = Eigen::AngleAxisd(0.7, Vec3(1, 2, -1).normalized()).toRotationMatrix();
  RandomStream random(5);
  int from_behind = 0;
  for (int i = 0; i < 400; ++i) {
    const Vec3 a_W = surface.p_WP + anywhere(random, 0.1), b_W = surface.p_WP + anywhere(random, 0.1);
    const double plain = plain_along(surface, a_W, b_W);
    const auto hit = line_hit(surface, a_W, b_W);
    EXPECT_EQ(hit.has_value(), std::isfinite(plain)) << i;
    if (!hit || !std::isfinite(plain)) continue;
    EXPECT_NEAR(hit->along, plain, 1e-12) << i;  // rounding of two formulas for one place
    EXPECT_LT((hit->point_W - (a_W + plain * (b_W - a_W))).norm(), 1e-12);
    EXPECT_NEAR(hit->normal_W.norm(), 1, 1e-12);
    from_behind += hit->normal_W.dot(b_W - a_W) > 0;
  }
  return from_behind;
}

TEST(LineHit, IsTheNearestFacetFromEitherSideOfAnyPart) {
  const TriangleSoup torus = test::torus_soup(0.05, 0.02, 24, 12);
  EXPECT_GT(expect_plain_hits(torus), 10) << "lines that start within";
  EXPECT_GT(expect_plain_hits(test::reversed(torus)), 100);
  EXPECT_GT(expect_plain_hits(test::square_soup(0.1, 3)), 20);
  // Sheets one behind another, of which some are seen from their back.
  TriangleSoup sheets = test::square_soup(0.1, 2);
  for (int k = 1; k < 6; ++k) {
    TriangleSoup sheet = test::moved(test::square_soup(0.1, 2), Vec3(0, 0, 0.004 * k));
    if (k % 2 == 0) sheet = test::reversed(sheet);
    sheets = test::joined(sheets, sheet);
  }
  EXPECT_GT(expect_plain_hits(sheets), 50);
}

TEST(LineHit, MayEndOnAFacetThatIsSeenFromBehind) {
  const Surface surface = test::world_of(test::square_soup(0.1, 3))->surfaces[0];
  for (const double z_m : {0.0, 1e-18, -1e-18}) {
    const auto hit = line_hit(surface, Vec3(0.011, 0.013, -1), Vec3(0.011, 0.013, z_m));
    if (hit) {
      EXPECT_NEAR(hit->along, 1, 1e-9);
    }
  }
  EXPECT_FALSE(line_hit(surface, Vec3(0.011, 0.013, -1), Vec3(0.011, 0.013, -1e-3)));
}

TEST(LineHit, OfAPlaneIsSeenFromItsOutsideAlone) {
  const Surface plane = test::plane_world()->surfaces[0];
  const auto hit = line_hit(plane, Vec3(1, 2, 3), Vec3(1, 2, -1));
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->point_W, Vec3(1, 2, 0));
  EXPECT_EQ(hit->along, 0.75);
  EXPECT_FALSE(line_hit(plane, Vec3(1, 2, -1), Vec3(1, 2, 3)));
  EXPECT_FALSE(line_hit(plane, Vec3(1, 2, 3), Vec3(1, 2, 1)));
}

/// Two bars `gap_m` apart over a floor that is one part with them.
ViewInput bars_over_floor(double gap_m) {
  const TriangleSoup bar = test::box_soup({0.05, 0.1, 0.005});
  const double off_m = 0.025 + gap_m / 2;
  const TriangleSoup bars =
      test::joined(test::moved(bar, {off_m, 0, -0.0025}), test::moved(bar, {-off_m, 0, -0.0025}));
  ViewInput input = test::torus_rub(0);
  World world =
      *test::world_of(test::joined(bars, test::moved(test::box_soup({0.2, 0.2, 0.01}), {0, 0, -0.045})));
  world.verdicts.emplace_back().closed = true;
  input.world = std::make_shared<World>(world);
  input.rows.clear();
  return input;
}

// What is seen through a slot was pointed at, and the finger went round the bars to it.
TEST(WorldProps, AFingerIsMeantOnTheBarsWhoseSlotItIsTooLargeFor) {
  const VirtualScreen screen;
  const Vec3 above_mm(1, 0, 100), below_mm(1, 0, -100);
  constexpr double radius_m = 0.007;
  const auto hit_through = [&](double gap_m) {
    Stage stage(bars_over_floor(gap_m), 400, 300, true, false);
    const auto seen = stage.world().first_hit(above_mm, below_mm);
    EXPECT_TRUE(seen && std::abs(seen->point_W.z() + 0.04) < 1e-9) << "the floor is seen";
    return stage.world().finger_hit(above_mm, below_mm, radius_m);
  };
  const auto rim = hit_through(0.008);
  ASSERT_TRUE(rim);
  EXPECT_TRUE(rim->on_rim);
  EXPECT_EQ(rim->normal_W, Vec3(Vec3::UnitZ()));
  EXPECT_NEAR(rim->point_W.z() + radius_m, std::sqrt(radius_m * radius_m - 9e-6), 0.02 * radius_m);
  const auto floor = hit_through(0.016);
  ASSERT_TRUE(floor);
  EXPECT_FALSE(floor->on_rim);
  EXPECT_NEAR(floor->point_W.z(), -0.04, 1e-9);
}

std::size_t bytes_held() {
  const struct mallinfo2 held = mallinfo2();
  return held.uordblks + held.hblkhd;
}

// What is built for it would be built while a person waits for the first answer of the pointer.
TEST(WorldProps, TheFirstLineOfSightBuildsNothing) {
  const VirtualScreen screen;
  const ViewInput input = test::torus_rub(0.2);
  Stage stage(input, 400, 300, true, false);
  const Vec3 above_mm(50, 0, 200), below_mm(50, 0, -200);
  const std::size_t before = bytes_held();
  ASSERT_TRUE(stage.world().first_hit(above_mm, below_mm));
  const std::size_t after = bytes_held();
  EXPECT_LT(after, before + 1000) << "a search tree of these 4096 facets takes over 100,000 bytes";
}

}  // namespace
}  // namespace fingerpad::surface_hit_test
