#include "device/tried_steps.hpp"

#include <gtest/gtest.h>

#include "scene/scene.hpp"
#include "support/worlds.hpp"

namespace fingerpad::tried_steps_test {
namespace {

// A finger that can go nowhere in a tick is put out at once, and does not look for a way without end.
TEST(TriedSteps, GivesWayAllTheWayWhereAShortStepIsNone) {
  const Scene scene = test::plane_scene("none");
  const auto world = test::plane_world();
  constexpr double dt_s = 1e-3;
  TickRecord touched;
  touched.depth_m = 2e-3;
  touched.normal_W = Vec3::UnitZ();
  const Vec3 start_W(0, 0, scene.finger.radius_m - touched.depth_m);
  for (const double farthest_m : {0.0, 1e-5, 1.0}) {
    SCOPED_TRACE(farthest_m);
    Surroundings around(world, scene);
    Foresight foresight(world, scene);
    FreeFlight flight(around, start_W);
    TriedSteps steps(foresight, flight);
    foresight.go_n(start_W, dt_s);
    steps.give_way(touched, 0, 0, farthest_m, dt_s);
    EXPECT_NEAR(flight.place_W().z(), scene.finger.radius_m, 1e-12);
  }
}

}  // namespace
}  // namespace fingerpad::tried_steps_test
