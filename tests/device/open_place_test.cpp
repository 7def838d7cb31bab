#include "device/open_place.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <utility>

#include "scene/scene.hpp"
#include "support/shapes.hpp"
#include "support/worlds.hpp"
#include "touch/finger_room.hpp"

namespace fingerpad::open_place_test {
namespace {

Scene fingertip_scene() {
  Scene scene = test::plane_scene("none");
  scene.finger.radius_m = 0.007;
  return scene;
}

/// A press at this place of a block whose top is z = 0.
PointerAim press_at(double x_m, double radius_m) {
  PointerAim aim;
  aim.spot_W = Vec3(x_m, 0, 0);
  aim.finger.p_WQ = Vec3(x_m, 0, radius_m);
  aim.finger.push_W_n = -Vec3::UnitZ();
  return aim;
}

// What no way led to is what was aimed at when the flight gave up, in the view of that time.
TEST(OpenPlace, GivesUpWhatWasTriedAndNoOther) {
  const Scene scene = fingertip_scene();
  const auto world = test::world_of(test::moved(test::box_soup({0.1, 0.1, 0.03}), {0, 0, -0.015}));
  const Surroundings around(world, scene);
  constexpr double soft_m = 1e-3;
  OpenPlace open(*world, around, soft_m);
  const PointerAim tried = press_at(0, scene.finger.radius_m), other = press_at(0.02, scene.finger.radius_m);
  open.aim(tried);
  ASSERT_TRUE(open.has_room());
  open.give_up();
  open.aim(other);
  EXPECT_TRUE(open.has_room());
  EXPECT_EQ(open.place_W(), other.finger.p_WQ);

  open.aim(tried);
  open.give_up();
  open.aim(tried);
  EXPECT_FALSE(open.has_room());
  open.aim(press_at(0.5 * soft_m, scene.finger.radius_m));
  EXPECT_FALSE(open.has_room()) << "beside it";
  PointerAim turned = tried;
  turned.towards_eye_W = Vec3(0.01, 0, 1).normalized();
  open.aim(turned);
  EXPECT_FALSE(open.has_room()) << "the same view, as a flight takes it";
  turned.towards_eye_W = Vec3(0.2, 0, 1).normalized();
  open.aim(turned);
  EXPECT_TRUE(open.has_room()) << "another view";
}

// About the middle of a fine sphere all triangles are as near as any: no tick's looks suffice there.
TEST(OpenPlace, HasNoRoomNearWhatABrokenOffSearchHasFound) {
  constexpr double sphere_m = 0.005;
  const Scene scene = fingertip_scene();
  const auto world = test::world_of(test::sphere_soup(sphere_m, 6));
  const Surroundings around(world, scene);
  Looks looks(20000);
  ASSERT_FALSE(nearest_surface(*world, Vec3::Zero(), Normals::facet, scene.finger.radius_m, looks).is_sure);
  OpenPlace open(*world, around, 1e-4);
  PointerAim aim;
  aim.finger.p_WQ.setZero();
  aim.finger.push_W_n = -Vec3::UnitZ();
  aim.spot_W = Vec3(0, 0, -sphere_m);
  open.aim(aim);
  EXPECT_FALSE(open.has_room());
}

/// The lower part of a sphere, open above.
TriangleSoup bowl_soup(double bowl_m, int subdivisions) {
  TriangleSoup soup = test::sphere_soup(bowl_m, subdivisions);
  int kept = 0;
  for (int t = 0; t < soup.triangles.cols(); ++t) {
    if (soup.vertices_P(2, soup.triangles(0, t)) > 0) continue;
    soup.triangles.col(kept++) = soup.triangles.col(t).eval();
  }
  soup.triangles.conservativeResize(3, kept);
  return soup;
}

/// How high over its lowest place a finger is held in so many bowls that lie in one another, at once and
/// after a pointer has rested.
std::pair<double, double> held_in_bowls(std::size_t count) {
  constexpr double bowl_m = 0.02, soft_m = 1e-4;
  const Scene scene = fingertip_scene();
  World world = *test::world_of(bowl_soup(bowl_m, 5));
  const Surface coarse = test::world_of(bowl_soup(bowl_m, 3))->surfaces.front();
  world.surfaces.insert(world.surfaces.end(), count, coarse);
  const auto shared = std::make_shared<World>(world);
  const Surroundings around(shared, scene);
  OpenPlace open(*shared, around, soft_m);
  PointerAim aim = press_at(0, scene.finger.radius_m);
  aim.spot_W = aim.finger.p_WQ = Vec3(0, 0, -bowl_m);  // in the bowl's wall: no room
  open.aim(aim);
  EXPECT_FALSE(open.has_room());
  const double lowest_m = scene.finger.radius_m - bowl_m, first_m = open.place_W().z();
  for (int k = 0; k < 100; ++k) open.aim(aim);
  return {first_m - lowest_m, open.place_W().z() - lowest_m};
}

// About the middle of a fine bowl all triangles are as near as any: there a tick's looks may end.
TEST(OpenPlace, LooksFurtherUnderAPointerThatRests) {
  bool ended = false;
  for (std::size_t count = 0; count <= 16 && !ended; ++count) {
    const auto [first_m, last_m] = held_in_bowls(count);
    ended = first_m > 1e-3;
    EXPECT_LT(last_m, 0.02 * first_m + 1e-4) << "first " << first_m << " with " << count;
  }
  EXPECT_TRUE(ended) << "the looks sufficed at once";
}

}  // namespace
}  // namespace fingerpad::open_place_test
