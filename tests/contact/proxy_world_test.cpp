#include "contact/proxy_world.hpp"

#include <gtest/gtest.h>

#include "base/random_stream.hpp"
#include "contact/proxies.hpp"
#include "support/shapes.hpp"

// What a world tells of its triangles, asked again and again.

namespace fingerpad::proxy_world_test {
namespace {

TEST(ProxyWorld, TellsOfAPlaceAskedAgainWhatItIsAndNotWhatItWasElsewhere) {
  const PlacedSurface one = surface_of(test::sphere_soup(0.03, 1)),
                      other = surface_of(test::box_soup(Vec3(1, 2, 3)));
  const ProxyWorld world({one, other}, 1e-3, Normals::facet);
  RandomStream random(7);
  const auto pick = [&random](int count) {
    return std::min(count - 1, static_cast<int>(count * random.uniform()));
  };
  const Vec3 places_O[] = {Vec3(0.05, 0, 0), Vec3(0, 0.05, 0), Vec3(0.05, 0, 1e-9)};
  for (int k = 0; k < 3000; ++k) {
    // Few enough that most of them were asked a little while ago.
    const int surface = pick(2), triangle = pick(3);
    const Vec3& place_O = places_O[pick(3)];
    const TriangleApproach told = world.approach(surface, triangle, place_O);
    const TriangleApproach is =
        approach_triangle(world.part(surface), triangle, world.in_part(surface, place_O));
    ASSERT_EQ(told.distance_m, is.distance_m);
    ASSERT_EQ(told.towards, is.towards);
    ASSERT_EQ(told.at.point, is.at.point);
  }
}

}  // namespace
}  // namespace fingerpad::proxy_world_test
