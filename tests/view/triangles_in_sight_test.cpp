#include "view/triangles_in_sight.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "base/random_stream.hpp"
#include "contact/triangle_tree.hpp"
#include "part/part.hpp"
#include "support/shapes.hpp"

namespace fingerpad::triangles_in_sight_test {
namespace {

/// A torus that is turned and moved, so that its own frame is not the world's.
Surface turned_torus() {
  Surface surface;
  surface.part = std::make_shared<const Part>(make_part(test::torus_soup(0.05, 0.02, 64, 32), 0.5));
  surface.tree = std::make_shared<const TriangleTree>(surface.part);
  surface.R_WP << 0, 0, 1, 1, 0, 0, 0, 1, 0;
  surface.p_WP = Vec3(0.3, -0.2, 0.1);
  return surface;
}

Vec3 corner_W(const Surface& surface, int triangle, int corner) {
  const Part& part = *surface.part;
  return surface.p_WP + surface.R_WP * (part.centre_P + part.vertices.col(part.triangles(corner, triangle)));
}

/// Looks down onto the outside of the torus, from where a triangle's normal points.
CloseUpSight sight_of(const Surface& surface, int triangle, double reach_m, double across_m) {
  const Vec3 a = corner_W(surface, triangle, 0), b = corner_W(surface, triangle, 1),
             c = corner_W(surface, triangle, 2);
  return {(a + b + c) / 3, (b - a).cross(c - a).normalized(), reach_m, across_m};
}

/// Whether any of many points of a triangle lies in the sight: what a camera could show of it.
bool is_seen(const Surface& surface, int triangle, const CloseUpSight& sight) {
  constexpr int steps = 12;
  for (int i = 0; i <= steps; ++i) {
    for (int k = 0; i + k <= steps; ++k) {
      const double u = static_cast<double>(i) / steps, v = static_cast<double>(k) / steps;
      const Vec3 p = (1 - u - v) * corner_W(surface, triangle, 0) + u * corner_W(surface, triangle, 1) +
                     v * corner_W(surface, triangle, 2);
      const Vec3 way = p - sight.contact_W;
      const double beside_m = (way - way.dot(sight.normal_W) * sight.normal_W).norm();
      if (way.norm() <= sight.reach_m && beside_m <= sight.across_m) return true;
    }
  }
  return false;
}

TEST(TrianglesInSight, AreAllThatTheCameraSeesAndFewOthers) {
  const Surface surface = turned_torus();
  const int all = surface.part->triangle_count();
  for (const double across_m : {0.0005, 0.004, 0.012}) {
    const double reach_m = 6 * across_m;
    for (int triangle = 0; triangle < all; triangle += 397) {
      const CloseUpSight sight = sight_of(surface, triangle, reach_m, across_m);
      const std::vector<int> found = triangles_in_sight(surface, sight);
      EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
      EXPECT_EQ(std::adjacent_find(found.begin(), found.end()), found.end()) << "each once";
      for (int t = 0; t < all; ++t) {
        if (is_seen(surface, t, sight)) {
          EXPECT_TRUE(std::binary_search(found.begin(), found.end(), t)) << t << " from " << triangle;
        }
      }
      // A facet is up to 7 mm long: of 4096 those near the beam, on both sides of the tube, are few.
      EXPECT_LT(found.size(), 400u) << across_m;
    }
  }
}

TEST(TrianglesInSight, WithoutATreeAreAll) {
  Surface surface = turned_torus();
  surface.tree = nullptr;
  const std::vector<int> found = triangles_in_sight(surface, {Vec3::Zero(), Vec3::UnitZ(), 1e-6, 1e-6});
  EXPECT_EQ(static_cast<int>(found.size()), surface.part->triangle_count());
}

TEST(CloseUpSight, IsAnotherWhereTheContactMoves) {
  const CloseUpSight none;
  EXPECT_FALSE(none == none) << "before the first contact nothing is kept";
  CloseUpSight one{Vec3(1, 2, 3), Vec3::UnitZ(), 0.01, 0.002};
  EXPECT_TRUE(one == one);
  CloseUpSight moved = one;
  moved.contact_W.x() += 1e-9;
  EXPECT_FALSE(one == moved);
}

}  // namespace
}  // namespace fingerpad::triangles_in_sight_test
