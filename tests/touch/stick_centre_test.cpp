#include "touch/stick_centre.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "base/random_stream.hpp"
#include "base/tangent_frame.hpp"
#include "support/shapes.hpp"
#include "support/worlds.hpp"

namespace fingerpad::stick_centre_test {
namespace {

/// A random contact with a part: of a finger just outside.
WorldPoint random_contact(const Surface& surface, Normals normals, RandomStream& random) {
  const Vec3 towards = Vec3(random.normal(), random.normal(), random.normal()).normalized();
  return nearest_point(surface, 0.2 * towards, normals, -1, 1);
}

TEST(StickCentre, LiesOnTheSurfaceAsFarBehindAsTheLawSays) {
  const auto world = test::world_of(test::sphere_soup(0.1, 5));
  const Surface& surface = world->surfaces[0];
  RandomStream random(2);
  for (const Normals normals : {Normals::facet, Normals::smooth, Normals::curved}) {
    for (int trial = 0; trial < 2000; ++trial) {
      const WorldPoint at = random_contact(surface, normals, random);
      const Mat3 frame_WC =
          tangent_frame(at.normal_W, Vec3(random.normal(), random.normal(), random.normal()));
      const double distance_m = 3e-3 * random.uniform();  // facets are 3 mm wide: on the same, or others
      const Vec2 stretch_m = distance_m * Vec2(random.normal(), random.normal()).normalized();
      for (const int triangle : {at.triangle, -1}) {
        StickCentre centre;
        centre.place(surface, at.point_W, frame_WC.leftCols<2>() * stretch_m, normals, triangle);
        ASSERT_TRUE(centre.is_set());
        const WorldPoint there = nearest_point(surface, centre.point_W(), normals, -1, 1);
        ASSERT_LT(std::abs(there.signed_distance_m), 1e-11) << trial;
        ASSERT_NEAR((centre.point_W() - at.point_W).norm(), distance_m, 0.11 * distance_m);
      }
    }
  }
}

TEST(StickCentre, BeyondARimIsPutOnTheRim) {
  const auto world = test::world_of(test::square_soup(0.02, 2));
  const Surface& surface = world->surfaces[0];
  StickCentre centre;
  // S lies 1 mm from the sheet's rim, its centre 3 mm towards it: 2 mm beyond.
  centre.place(surface, Vec3(0.009, 0.001, 0), Vec3(-0.003, 0, 0), Normals::smooth, -1);
  EXPECT_LT((centre.point_W() - Vec3(0.010, 0.001, 0)).norm(), 1e-15);
}

TEST(StickCentre, AnUnstretchedOneIsTheContactPointItself) {
  const auto world = test::world_of(test::square_soup(0.02, 2));
  StickCentre centre;
  EXPECT_FALSE(centre.is_set());
  centre.place(world->surfaces[0], Vec3(0.001, 0.002, 0), Vec3::Zero(), Normals::smooth, -1);
  EXPECT_TRUE(centre.is_set());
  EXPECT_EQ(centre.point_W(), Vec3(0.001, 0.002, 0));
}

}  // namespace
}  // namespace fingerpad::stick_centre_test
