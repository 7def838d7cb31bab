#include "support/signs.hpp"
#include "contact/triangle_tree.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace fingerpad::test {

int expect_touchable(const std::shared_ptr<const Part>& part, int count,
                     const std::function<bool(const Vec3&)>& inside) {
  const TriangleTree tree(part);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> share(-1.2, 1.2);
  constexpr double everywhere = std::numeric_limits<double>::infinity();
  int count_inside = 0;
  for (int i = 0; i < count; ++i) {
    const Vec3 around(share(random), share(random), share(random));
    const Vec3 p = part->centre_P + around.cwiseProduct(part->half_extent) + 0.1 * part->size_m() * around;
    const SurfacePoint near = nearest_surface_point(tree, p, Normals::smooth, -1, everywhere);
    EXPECT_GE(near.triangle, 0);
    EXPECT_TRUE(std::isfinite(near.signed_distance_m) && near.point_P.allFinite());
    EXPECT_NEAR(near.normal_P.norm(), 1, 1e-12);  // a few roundings of a square root
    EXPECT_NEAR(near.pseudonormal_P.norm(), 1, 1e-12);
    if (std::abs(near.signed_distance_m) < 1e-6 * part->size_m()) continue;
    count_inside += near.signed_distance_m < 0 ? 1 : 0;
    if (!inside) continue;
    EXPECT_EQ(near.signed_distance_m < 0, inside(p)) << p.transpose();
  }
  return count_inside;
}

}  // namespace fingerpad::test
