// A finger that is let go between two walls that leave it no room.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "device/pointer_finger.hpp"
#include "scene/scene.hpp"
#include "support/worlds.hpp"
#include "touch/touch.hpp"

namespace fingerpad::pointer_lift_test {
namespace {

constexpr double press_n = 10, dt_s = 1e-3, radius_m = 0.007;

/// A floor, and so high over it a ceiling of another stiffness.
std::shared_ptr<const World> gap(double height_m, double ceiling_n_per_m) {
  World world = *test::plane_world();
  Surface& ceiling = world.surfaces.emplace_back();
  ceiling.plane_point_W = Vec3(0, 0, height_m);
  ceiling.plane_normal_W = -Vec3::UnitZ();
  ceiling.properties.stiffness_n_per_m = ceiling_n_per_m;
  return std::make_shared<World>(world);
}

struct Lifted {
  double most_n = 0;   ///< normal force
  int free_tick = -1;  ///< the first without contact
  double roams_m = 0;  ///< in the last half
};

Scene scene_with(const std::string& method) {
  Scene scene = test::plane_scene("none");
  scene.finger.radius_m = radius_m;
  scene.contact.method = method;
  scene.contact.greatest_force_n = press_n;
  return scene;
}

/// Presses the floor under a high ceiling, and is let go in this world: touched by another method, it is seen
/// as it is.
Lifted let_go(const std::shared_ptr<const World>& then) {
  const Scene scene = scene_with("proxy"), then_scene = scene_with("closest-point");
  const auto world = gap(1, 1000);
  FingerSample target{0, Vec3(0, 0, radius_m), Vec3::UnitY()};
  PointerFinger finger({scene, world, target});
  std::optional<Touch> touch(std::in_place, world, scene);
  target.push_W_n = Vec3(0, 0, -press_n);
  finger.set_target(target);
  std::vector<TickRecord> rows;
  const auto go = [&](int ticks) {
    rows.clear();
    for (int k = 0; k < ticks; ++k) {
      rows.push_back(touch->tick(finger.advance(dt_s)));
      finger.feel(rows.back());
    }
  };
  go(1000);
  EXPECT_NEAR(rows.back().normal_force_n, press_n, 0.1 * press_n);
  finger.ready_for(*then, then_scene)->put_in();
  touch.emplace(then, then_scene);
  target.push_W_n.setZero();
  target.t_s = 1;
  finger.set_target(target);
  go(600);
  Lifted lifted;
  for (int k = 0; k < 600; ++k) {
    const TickRecord& row = rows[static_cast<std::size_t>(k)];
    lifted.most_n = std::max(lifted.most_n, row.normal_force_n);
    if (lifted.free_tick < 0 && row.walls == 0) lifted.free_tick = k;
    if (k >= 300) lifted.roams_m = std::max(lifted.roams_m, (row.p_WQ - rows.back().p_WQ).norm());
  }
  return lifted;
}

TEST(PointerLift, PressesTheOtherWallNoHarderThanAPressMay) {
  for (const double ceiling_n_per_m : {2000.0, 5000.0, 20000.0}) {
    SCOPED_TRACE(ceiling_n_per_m);
    const Lifted lifted = let_go(gap(2 * radius_m - 1.1e-3, ceiling_n_per_m));
    EXPECT_LE(lifted.most_n, 1.011 * press_n);
    EXPECT_LT(lifted.roams_m, 1e-6) << "it comes to rest";
  }
}

TEST(PointerLift, IsFreeAsSoonAsItsPaceLetsItBe) {
  const Lifted lifted = let_go(gap(1, 1000));
  EXPECT_LE(lifted.most_n, 1.011 * press_n);
  // 10 mm at 0.5 m/s, and what the pointer's event is played late by.
  EXPECT_GE(lifted.free_tick, 10);
  EXPECT_LE(lifted.free_tick, 50);
}

}  // namespace
}  // namespace fingerpad::pointer_lift_test
