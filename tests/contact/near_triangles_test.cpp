#include "contact/near_triangles.hpp"

#include <gtest/gtest.h>

#include "base/random_stream.hpp"
#include "contact/proxies.hpp"
#include "contact/proxy_memory_limits.hpp"
#include "support/effort.hpp"
#include "support/shapes.hpp"

// A view's triangles, most of which are passed over, against looking at all of a part's.

namespace fingerpad::near_triangles_test {
namespace {

Vec3 any(RandomStream& random) {
  return {random.normal(), random.normal(), random.normal()};
}

/// A place that keeps the clearance by up to so much more, near another.
Vec3 clear_place(const ProxyWorld& world, const Vec3& near_P, double more_m, RandomStream& random) {
  const ClosestTriangle closest = world.surface(0).tree->closest(near_P, -1, HUGE_VAL);
  const Vec3 out = (near_P - closest.at.point).normalized();
  return closest.at.point + (world.clearance_m() + more_m * random.uniform()) * out;
}

WorstWall worst_of_all(const ProxyWorld& world, const PartWay& way, std::span<const ProxyWall> walls) {
  const PartWalls before(world, 0, walls, way.from_P);
  WorstWall worst{std::nullopt, -world.tolerance_m()};
  for (int t = 0; t < world.part(0).triangle_count(); ++t) {
    const TriangleCorners corners = corners_of(world.part(0), t);
    if (before.hide(corners)) continue;
    worst.offer_triangle(world, way, corners, t, FirstApproach(approach_triangle(corners, way.from_P)));
  }
  return worst;
}

struct Offered {
  WorstWall worst{std::nullopt, 0};
  long looks = 0;
};

Offered worst_in_view(NearTriangles& near, const ProxyWorld& world, const Vec3& z,
                      std::span<const ProxyWall> walls) {
  Offered offered;
  offered.worst.slack_m = -world.tolerance_m();
  Looks looks(Looks::unlimited);
  std::size_t next = 0;
  EXPECT_TRUE(near.offer(world, 0, z, walls, next, offered.worst, looks));
  offered.looks = looks.spent();
  return offered;
}

// In a crowded view most triangles are told by their own plane, and what it leaves of their gap serves again
// from the next places: no wall may be lost by that.
TEST(NearTriangles, OfferTheWorstWallOfACrowdedViewFromEveryPlaceInIt) {
  RandomStream random(4);
  const int searches = test::samples(60);
  int blocked = 0, views = 0;
  for (const TriangleSoup& soup :
       {test::torus_soup(0.02, 0.008, 96, 48), test::sphere_soup(0.03, 4),
        test::joined(test::box_soup(Vec3(0.02, 0.015, 0.01)),
                     test::moved(test::torus_soup(0.01, 0.003, 60, 30), Vec3(0, 0, 0.006)))}) {
    const PlacedSurface surface = surface_of(soup);
    for (int k = 0; k < searches; ++k) {
      const ProxyWorld world({surface}, k % 2 == 0 ? 0.003 : 0, Normals::facet);
      const double reach_m = 0.004 + 0.006 * random.uniform();
      const Vec3 middle_P = clear_place(world, 0.03 * any(random), 1e-3, random);
      NearTriangles near(world);
      Looks looks(Looks::unlimited);
      // Where nothing is turned or moved, frame O is the part's.
      ASSERT_TRUE(near.search(world, middle_P, reach_m, ProxyMemoryLimits::richest_view, {}, looks));
      if (near.count() <= ProxyMemoryLimits::small_view) continue;
      ++views;
      for (int place = 0; place < 6; ++place) {
        const double off_m = place == 0 ? 0 : reach_m / 4;
        const Vec3 from_P =
            place == 0 ? middle_P
                       : clear_place(world, middle_P + off_m * any(random).normalized(), 1e-4, random);
        const double left_m = reach_m - (from_P - middle_P).norm();
        if (left_m <= 0) continue;
        near.look_from(world, from_P);
        std::vector<ProxyWall> walls;
        for (int pass = 0; pass < 3; ++pass) {
          const Vec3 z = left_m * random.uniform() * any(random).normalized();
          const PartWay way(world, 0, from_P, z);
          const WorstWall expected = worst_of_all(world, way, walls);
          const WorstWall found = worst_in_view(near, world, z, walls).worst;
          ASSERT_EQ(found.wall.has_value(), expected.wall.has_value()) << k << " " << place << " " << pass;
          if (!found.wall) continue;
          ASSERT_EQ(found.wall->triangle, expected.wall->triangle) << k << " " << place << " " << pass;
          ASSERT_EQ(found.slack_m, expected.slack_m);
          ASSERT_EQ(found.wall->normal, expected.wall->normal);
          walls.assign(1, *found.wall);
          ++blocked;
        }
      }
    }
  }
  EXPECT_GT(views, searches);
  EXPECT_GT(blocked, 200 * searches / 60);
}

TEST(NearTriangles, OfACrowdedViewClearEachByItsPlaneWithinThePriceOfThePass) {
  const PlacedSurface fine = surface_of(test::sphere_soup(0.03, 5));
  const ProxyWorld world({fine}, 0.003, Normals::facet);
  NearTriangles near(world);
  Looks looks(Looks::unlimited);
  const Vec3 place_P(0, 0, 0.034);
  ASSERT_TRUE(near.search(world, place_P, 0.004, ProxyMemoryLimits::richest_view, {}, looks));
  ASSERT_GT(near.count(), ProxyMemoryLimits::small_view);
  // Away from the sphere no triangle is told; each is held against its plane at most, for which those that
  // are no farther away than the way is long are fetched once. (Rough gaps may bring one or two more.)
  constexpr double way_m = 0.002;
  int fetched = 0;
  for (int t = 0; t < world.part(0).triangle_count(); ++t)
    fetched += approach_triangle(world.part(0), t, place_P).distance_m < world.clearance_m() + way_m ? 1 : 0;
  ASSERT_GT(fetched, 10);
  const Vec3 z(0, 0, way_m);
  EXPECT_LE(worst_in_view(near, world, z, {}).looks, near.count() + LookCosts::fetched * (fetched + 2));
  EXPECT_EQ(worst_in_view(near, world, z, {}).looks, near.count());
}

TEST(NearTriangles, ASearchEndsWhereItsLooksAreSpent) {
  const ProxyWorld world({surface_of(test::sphere_soup(0.03, 6))}, 0.003, Normals::facet);
  const Vec3 place(0, 0, 0.034);
  NearTriangles near(world);
  const auto cost = [&](long most) {
    Looks looks(most);
    EXPECT_FALSE(near.search(world, place, 0.02, ProxyMemoryLimits::richest_view, {}, looks));
    return looks.spent();
  };
  constexpr long a_packet = LookCosts::packet + 8 * (LookCosts::shadowed + LookCosts::listed);
  EXPECT_LE(cost(1), LookCosts::too_many + ProxyMemoryLimits::search_looks + a_packet);
  EXPECT_GT(cost(Looks::unlimited), cost(1) + 200) << "it would find too many";
}

}  // namespace
}  // namespace fingerpad::near_triangles_test
