#include "contact/surface_kind.hpp"

#include <gtest/gtest.h>

#include "contact/closest_memory.hpp"
#include "contact/limited_proxies.hpp"
#include "contact/placed_soup.hpp"
#include "support/wanderer.hpp"

// Parts and planes, asked for as what they are: surfaces.

namespace fingerpad::surface_kind_test {
namespace {

constexpr double far_m = 1e3;

TEST(SurfaceKind, IsAPartsWhereThereIsAMeshToTouchOrToLookAt) {
  PlacedSurface surface = test::placed(test::box_soup(Vec3(1, 2, 3)));
  EXPECT_EQ(&surface.kind(), &part_kind) << "without a tree";
  surface.tree = std::make_shared<const TriangleTree>(surface.part);
  EXPECT_EQ(&surface.kind(), &part_kind);
  EXPECT_EQ(&surface_of(test::box_soup(Vec3(1, 2, 3))).kind(), &part_kind) << "with a tree alone";
  EXPECT_EQ(&plane_of(Vec3::Zero(), Vec3::UnitX()).kind(), &plane_kind);
  EXPECT_FALSE(part_kind.name == plane_kind.name);
}

TEST(SurfaceKind, OfEitherSortAnswersTheSameWhateverASearchStartsFrom) {
  PlacedSurface part = test::placed(test::box_soup(Vec3(0.04, 0.03, 0.02)));
  part.tree = std::make_shared<const TriangleTree>(part.part);
  const PlacedSurface plane = plane_of(Vec3(0.3, 0, 0.1), Vec3(0.6, 0, 0.8));
  for (const PlacedSurface* surface : std::initializer_list<const PlacedSurface*>{&part, &plane}) {
    ClosestMemory memory;
    for (int k = 0; k < 50; ++k) {
      const Vec3 p_W = part.p_WP + Vec3(0.03 - 1e-3 * k, 0.01, 0.03);
      const WorldPoint seeded = nearest_point(*surface, p_W, Normals::smooth, -1, far_m);
      BriefSearch brief{100000};
      for (const WorldPoint& other : {nearest_point(*surface, p_W, Normals::smooth, memory, far_m),
                                      nearest_point(*surface, p_W, Normals::smooth, brief, far_m)}) {
        ASSERT_TRUE(seeded.found && other.found);
        ASSERT_EQ(other.point_W, seeded.point_W);
        ASSERT_EQ(other.normal_W, seeded.normal_W);
        ASSERT_EQ(other.signed_distance_m, seeded.signed_distance_m);
        ASSERT_EQ(other.triangle, seeded.triangle);
      }
      ASSERT_EQ(seeded.triangle < 0, surface == &plane);
      const Vec3 above_W = seeded.point_W + 0.002 * seeded.normal_W;
      ASSERT_TRUE(nearest_point(*surface, above_W, Normals::smooth, -1, 0.002 + 1e-6).found);
      ASSERT_FALSE(nearest_point(*surface, above_W, Normals::smooth, -1, 0.002 - 1e-6).found);
    }
  }
}

TEST(SurfaceKind, ComesWithinABoxAsFarAsItReaches) {
  const WorldBox box{Vec3(0, 0, 1), Vec3(0.5, 0.5, 0.5)};
  const PlacedSurface plane = plane_of(Vec3::Zero(), Vec3::UnitZ());
  EXPECT_TRUE(comes_within(plane, box, 0.5));
  EXPECT_FALSE(comes_within(plane, box, 0.49));
  EXPECT_TRUE(comes_within(plane, {Vec3(0, 0, -5), Vec3::Zero()}, 0)) << "all behind it is taken as near";
  PlacedSurface cube = surface_of(test::box_soup(Vec3(1, 1, 1)));
  cube.p_WP = Vec3(0, 0, -1);
  EXPECT_TRUE(comes_within(cube, box, 1.01));
  EXPECT_FALSE(comes_within(cube, box, 0.99));
}

TEST(SurfaceKind, InWhichOrderTheyAreNamedIsOfNoMomentToAProxy) {
  const PlacedSurface box = surface_of(test::box_soup(Vec3(0.04, 0.03, 0.02))),
                      ring =
                          surface_of(test::moved(test::torus_soup(0.02, 0.006, 24, 12), Vec3(0, 0, 0.012))),
                      floor = plane_of(Vec3(0, 0, 0.013), Vec3::UnitZ()),
                      wall = plane_of(Vec3(0.015, 0, 0), Vec3(-0.8, 0, 0.6));
  const ProxyWorld named({floor, box, wall, ring}, 0.002, Normals::smooth);
  EXPECT_EQ(std::vector<int>(named.parts().begin(), named.parts().end()), (std::vector<int>{1, 3}));
  EXPECT_EQ(std::vector<int>(named.planes().begin(), named.planes().end()), (std::vector<int>{0, 2}));
  for (const long looks : {40L, 300L, 4000L}) {
    Proxy parts_first = fast_proxy({box, ring, floor, wall}, 0.002, Normals::smooth, Looks(looks));
    Proxy planes_between = fast_proxy({floor, box, wall, ring}, 0.002, Normals::smooth, Looks(looks));
    test::Wanderer finger(ring.tree->part());
    int touching = 0, by_planes = 0;
    for (int k = 0; k < 2000; ++k) {
      const Vec3 p_WQ = finger.next(0.3);
      const ProxyContact& a = parts_first.move(p_WQ, 1e-3);
      const ProxyContact& b = planes_between.move(p_WQ, 1e-3);
      ASSERT_EQ(parts_first.ball_W(), planes_between.ball_W()) << looks << " looks, tick " << k;
      ASSERT_EQ(a.hold_count, b.hold_count);
      ASSERT_EQ(a.normal_W, b.normal_W);
      ASSERT_EQ(a.broken_off, b.broken_off);
      ASSERT_EQ(parts_first.looks().spent(), planes_between.looks().spent());
      touching += a.hold_count > 0 ? 1 : 0;
      by_planes += a.hold_count > 0 && a.holds[0].surface > 1 ? 1 : 0;
    }
    EXPECT_GT(touching, 200);
    EXPECT_GT(by_planes, 20);
  }
}

}  // namespace
}  // namespace fingerpad::surface_kind_test
