// What a simulated hand does with what it is told: where it is wanted, its own settings, other surfaces.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "device/hand_finger.hpp"
#include "scene/scene.hpp"
#include "support/shapes.hpp"
#include "support/worlds.hpp"
#include "touch/touch.hpp"

namespace fingerpad::hand_target_test {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

FingerSample aim(const Vec3& p_W, const Vec3& push_W_n = Vec3::Zero()) {
  FingerSample target{0, p_W, Vec3::UnitY()};
  target.push_W_n = push_W_n;
  return target;
}

/// A hand in a world, and what it felt last.
struct HandRun {
  Scene scene;
  std::shared_ptr<const World> world;
  double dt_s = 1 / scene.motion.rate_hz;
  HandFinger finger;
  Touch touch{world, scene};
  FingerSample sample{};
  TickRecord row{};
  double most_n = 0;
  bool stays_finite = true;

  HandRun(const Scene& its_scene, const std::shared_ptr<const World>& its_world, const HandSettings& hand,
          const Vec3& start_W)
      : scene(its_scene), world(its_world), finger({scene, world, aim(start_W), {}, hand}, dt_s) {}

  void go(double seconds) {
    for (int k = 0; k * dt_s < seconds; ++k) {
      sample = finger.advance(dt_s);
      row = touch.tick(sample);
      finger.feel(row);
      most_n = std::max(most_n, row.normal_force_n);
      stays_finite = stays_finite && sample.p_WQ.allFinite() && sample.push_W_n.allFinite();
    }
  }
};

// Dragged off a part with the button held and back elsewhere, a pointer is at a new place and presses at
// once.
TEST(HandTarget, ComesDownOverTheNewSpotWhereItIsPressedInOneEvent) {
  const Scene scene = test::plane_scene("none");
  const auto world = test::world_of(test::box_soup({0.1, 0.1, 0.04}));
  const double radius_m = scene.finger.radius_m;
  const Vec3 beside_W(0.05 + radius_m + 0.004, 0, 0), top_W(0, 0, 0.02 + radius_m);
  for (const double press_n : {1.0, 5.0}) {
    SCOPED_TRACE(press_n);
    HandRun run(scene, world, {}, Vec3(0.08, 0, 0));
    run.finger.set_target(aim(beside_W));
    run.go(2);
    run.finger.set_target(aim(top_W, Vec3(0, 0, -press_n)));
    bool touched_side = false;
    for (int k = 0; k < 30; ++k) {
      run.go(0.1);
      touched_side |= run.row.walls > 0 && run.row.normal_W.z() < 0.5;
    }
    EXPECT_FALSE(touched_side);
    EXPECT_GT(run.row.normal_W.z(), 0.99);
    EXPECT_LT((run.sample.p_WQ - top_W).norm(), 0.01);
    EXPECT_GT(run.row.normal_force_n, 0.5 * press_n);
  }
}

// Its spring held it against the side that it was on, with up to half of the greatest force, for as long as
// the button was held.
TEST(HandTarget, GoesRoundAnEdgeThatThePointerHasJumpedRound) {
  const Scene scene = test::plane_scene("finger-pad");
  const auto world = test::world_of(test::box_soup({0.1, 0.1, 0.04}));
  const double radius_m = scene.finger.radius_m;
  for (const double press_n : {0.5, 1.0, 3.0}) {
    for (const Vec3& side : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 0, -1)}) {
      SCOPED_TRACE(testing::Message() << press_n << " N on " << side.transpose());
      HandRun run(scene, world, HandSettings{}, {0.02, 0, 0.05 + radius_m});
      run.finger.look_from({1, 0, 1});
      run.finger.set_target(aim({0.02, 0, 0.02 + radius_m}, {0, 0, -press_n}));
      run.go(2);
      ASSERT_GT(run.row.normal_force_n, 0.7 * press_n);
      run.most_n = 0;
      const Vec3 place_W =
          side.x() == 0 ? Vec3(0.02, 0, -0.02 - radius_m) : Vec3((0.05 + radius_m) * side.x(), 0, -0.005);
      run.finger.set_target(aim(place_W, -press_n * side));
      run.go(3);
      EXPECT_LT(run.most_n, 1.1 * press_n);
      EXPECT_GT(run.row.normal_force_n, 0.7 * press_n) << "on the new spot";
      EXPECT_GT(run.row.normal_W.dot(side), 0.99);
      EXPECT_LT((run.sample.p_WQ - place_W).norm(), 0.005);
    }
  }
}

TEST(HandTarget, StaysOnTheFaceThatItIsDraggedOver) {
  const Scene scene = test::plane_scene("finger-pad");
  const auto world = test::world_of(test::box_soup({0.3, 0.3, 0.04}));
  const double radius_m = scene.finger.radius_m, top_m = 0.02 + radius_m;
  for (const double press_n : {0.5, 1.0, 3.0}) {
    for (const double speed_m_per_s : {0.1, 0.4}) {
      SCOPED_TRACE(testing::Message() << press_n << " N at " << speed_m_per_s << " m/s");
      HandRun run(scene, world, HandSettings{}, {-0.1, 0, top_m + 0.03});
      run.finger.set_target(aim({-0.1, 0, top_m}, {0, 0, -press_n}));
      run.go(2);
      ASSERT_GT(run.row.normal_force_n, 0.7 * press_n);
      double x_m = -0.1;
      int free_ticks = 0;
      while (x_m < 0.1) {
        x_m += speed_m_per_s * run.dt_s;
        run.finger.set_target(aim({x_m, 0, top_m}, {0, 0, -press_n}));
        run.go(run.dt_s);
        free_ticks += run.row.walls == 0 ? 1 : 0;
      }
      EXPECT_EQ(free_ticks, 0);
    }
  }
}

// What steers it is made for a hand without dry friction, which eats up 1 N.
TEST(HandTarget, HoversAndLandsAgainstDryFriction) {
  const Scene scene = test::plane_scene("none");
  const auto world = test::world_of(test::box_soup({0.1, 0.1, 0.04}));
  HandSettings hand;
  hand.coulomb_n = 1;
  const Vec3 hover_W(0.02, 0.01, 0.04), top_W(0.02, 0.01, 0.02 + scene.finger.radius_m);
  for (const double press_n : {1.0, 3.0}) {
    SCOPED_TRACE(press_n);
    HandRun run(scene, world, hand, Vec3(-0.06, 0, 0.08));
    run.finger.set_target(aim(hover_W));
    run.go(3);
    EXPECT_LT((run.sample.p_WQ - hover_W).norm(), 1e-3);
    EXPECT_EQ(run.most_n, 0);
    run.finger.set_target(aim(top_W, Vec3(0, 0, -press_n)));
    run.go(3);
    EXPECT_GT(run.row.normal_force_n, 0.5 * press_n);
    EXPECT_LT(run.most_n, scene.contact.greatest_force_n);
    EXPECT_LT((run.sample.p_WQ - top_W).norm(), 0.01);
  }
}

// The surface pushes a hand out faster than its flight goes. A flight that drew it back in and waited for it
// would wait for ever: the two forces balance.
TEST(HandTarget, LetsGoOfWhatItHasPressed) {
  Scene scene = test::plane_scene("none");
  scene.finger.radius_m = 0.007;
  const auto world = test::world_of(test::box_soup({0.1, 0.1, 0.04}));
  const Vec3 beside_W(0.05 + scene.finger.radius_m, 0, 0), above_W(0, 0, 0.024 + scene.finger.radius_m);
  for (const double coulomb_n : {0.0, 0.3, 1.0, 3.0}) {
    SCOPED_TRACE(coulomb_n);
    HandSettings hand;
    hand.coulomb_n = coulomb_n;
    HandRun run(scene, world, hand, Vec3(0.08, 0, 0));
    run.finger.set_target(aim(beside_W, Vec3(-5, 0, 0)));
    run.go(2);
    EXPECT_GT(run.row.normal_force_n, 2.5);
    run.finger.set_target(aim(above_W));
    run.go(3);
    EXPECT_LT((run.sample.p_WQ - above_W).norm(), 2e-3);
  }
}

TEST(HandTarget, StaysFiniteWithoutASpring) {
  HandSettings hand;
  hand.stiffness_n_per_m = 0;
  const Vec3 start_W(0, 0, 0.03);
  HandRun run(test::plane_scene("none"), test::plane_world(), hand, start_W);
  for (const double press_n : {0.0, 2.0}) {
    run.finger.set_target(aim(Vec3(0.02, 0, 0), Vec3(0, 0, -press_n)));
    run.go(0.5);
    EXPECT_TRUE(run.stays_finite) << press_n << " N";
  }
  EXPECT_LT((run.sample.p_WQ - start_W).norm(), 1e-4) << "nothing draws it";
}

// Along an axis that is not the hand's own it is where it is wanted, spring or none.
TEST(HandTarget, WithoutASpringFollowsAlongTheAxesThatAreNotItsOwn) {
  HandSettings hand;
  hand.stiffness_n_per_m = 0;
  hand.free_axis[0] = false;
  HandRun run(test::plane_scene("none"), test::plane_world(), hand, Vec3(0, 0, 0.03));
  run.finger.set_target(aim(Vec3(0.02, 0, 0.02)));
  run.go(1);
  EXPECT_TRUE(run.stays_finite);
  EXPECT_LT((run.sample.p_WQ - Vec3(0.02, 0, 0.03)).norm(), 1e-4);
}

TEST(HandTarget, DoesNotListenToWhatIsNotFinite) {
  const Vec3 hover_W(0.02, 0, 0.03);
  for (const double odd : {infinite, -infinite, not_a_number}) {
    SCOPED_TRACE(odd);
    HandRun run(test::plane_scene("none"), test::plane_world(), {}, Vec3(0, 0, 0.03));
    run.finger.set_target(aim(hover_W));
    for (const FingerSample& target :
         {aim(Vec3(0, 0, odd)), aim(hover_W, Vec3(0, 0, odd)), FingerSample{0, hover_W, Vec3(0, odd, 0)}}) {
      run.finger.look_from(Vec3(odd, 0, 1));
      run.finger.set_target(target);
      run.go(1);
    }
    EXPECT_TRUE(run.stays_finite);
    EXPECT_LT((run.sample.p_WQ - hover_W).norm(), 1e-3) << "it goes where it was wanted before";
  }
}

// It is drawn against a wall as gently as the stiffest wall that it knows of asks for.
TEST(HandTarget, IsToldOfAStifferWall) {
  Scene scene = test::plane_scene("none");
  scene.motion.rate_hz = 4000;
  scene.finger.radius_m = 0.007;
  scene.contact.method = "proxy";
  scene.planes.resize(2);
  World world = *test::plane_world();
  world.surfaces.push_back(world.surfaces[0]);
  world.surfaces[1].plane_normal_W = -Vec3::UnitX();
  world.surfaces[1].plane_point_W = Vec3(0.06, 0, 0);
  HandRun run(scene, std::make_shared<World>(world), {}, Vec3(0, 0, 0.02));
  TouchSwap swap(run.world, scene);
  swap.change_too([&](const World& on, const Scene& by) { return run.finger.ready_for(on, by); });
  const Vec3 push_W_n(0, 0, -5);
  run.finger.set_target(aim(Vec3(0, 0, scene.finger.radius_m), push_W_n));
  run.go(2);
  swap.change({0, surface_key(1, "stiffness_n_per_m"), "20000"});
  swap.before_tick(run.touch, 2);
  run.most_n = 0;
  run.finger.set_target(aim(Vec3(0.2, 0, scene.finger.radius_m), push_W_n));
  run.go(2);
  EXPECT_EQ(swap.taken(0).size(), 1u);
  EXPECT_GT(run.sample.p_WQ.x(), 0.03) << "it came to the wall";
  EXPECT_LT(run.most_n, scene.contact.greatest_force_n);
}

}  // namespace
}  // namespace fingerpad::hand_target_test
