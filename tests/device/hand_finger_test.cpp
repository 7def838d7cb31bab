#include "device/hand_finger.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "device/pointed_worlds.hpp"
#include "scene/scene.hpp"
#include "support/effort.hpp"
#include "support/worlds.hpp"
#include "touch/touch.hpp"

namespace fingerpad::hand_finger_test {
namespace {

TEST(HandFinger, ChasesTheMouseAndIsHeldUpByTheSurface) {
  Scene scene;
  scene.motion.rate_hz = 1000;
  HandSettings hand;
  hand.stiffness_n_per_m = 200;
  hand.damping_n_s_per_m = 5;
  hand.encoder_m = 0;
  const FingerSample start{0, Vec3(0, 0, 0.01), Vec3::UnitY()};
  HandFinger finger({scene, nullptr, start, {}, hand}, 1e-3);
  finger.set_target({0, Vec3(0.02, 0, -0.01), Vec3::UnitY()});
  FingerSample sample;
  for (int k = 0; k < 3000; ++k) {
    sample = finger.advance(1e-3);
    TickRecord tick;
    if (sample.p_WQ.z() < 0) {
      tick.phase = Phase::slip;
      tick.force_W_n = Vec3(0, 0, -1000 * sample.p_WQ.z());
    }
    finger.feel(tick);
  }
  EXPECT_NEAR(sample.p_WQ.x(), 0.02, 1e-6);
  // 200 N/m pull down to -10 mm, 1000 N/m push up: at rest where they balance.
  EXPECT_NEAR(sample.p_WQ.z(), -0.01 * 200 / 1200, 1e-6);
}

TEST(HandFinger, IsFeltWhereItsEncodersPutItAndPushesWithItsSpring) {
  Scene scene;
  scene.motion.rate_hz = 1000;
  HandSettings hand;
  hand.stiffness_n_per_m = 200;
  hand.damping_n_s_per_m = 5;
  hand.encoder_m = 1e-4;
  const FingerSample start{0, Vec3(0, 0, 0.01), Vec3::UnitY()};
  HandFinger finger({scene, nullptr, start, {}, hand}, 1e-3);
  EXPECT_TRUE(finger.gives().pushes);
  finger.set_target({0, Vec3(0.02, 0, 0.01), Vec3::UnitY()});
  double most_off_m = 0;
  for (int k = 0; k < 300; ++k) {
    const FingerSample sample = finger.advance(1e-3);
    const Vec3 steps = sample.p_WQ / 1e-4;
    EXPECT_LT((steps - Vec3(steps.array().round())).norm(), 1e-9);
    most_off_m = std::max(most_off_m, (sample.p_WQ - finger.true_place_W().value()).cwiseAbs().maxCoeff());
    // On the way it is drawn along x, and by nothing else.
    if (k == 20) {
      EXPECT_GT(sample.push_W_n.x(), 0.1);
    }
    EXPECT_NEAR(sample.push_W_n.y(), 0, 1e-12);
    finger.feel({});
  }
  EXPECT_GT(most_off_m, 2e-5);
  EXPECT_LE(most_off_m, 0.5e-4 + 1e-12) << "half a step";
}

// As fast as it follows a pointer aside it would meet the surface with 2.3 N where 1 N is asked for.
TEST(HandFinger, LandsSoftly) {
  Scene scene = test::plane_scene("none");
  scene.motion.rate_hz = 4000;  // at 1 kHz the loop is at the edge of what is stable
  const double dt_s = 1 / scene.motion.rate_hz;
  const auto world = test::plane_world();
  for (const double press_n : {1.0, 5.0}) {
    for (const double hover_m : {0.005, 0.03}) {
      SCOPED_TRACE(testing::Message() << press_n << " N from " << hover_m << " m");
      HandSettings hand;
      hand.encoder_m = 0;
      HandFinger finger({scene, world, {0, Vec3(0, 0, hover_m), Vec3::UnitY()}, {}, hand}, dt_s);
      Touch touch(world, scene);
      FingerSample target{0, Vec3(0, 0, scene.finger.radius_m), Vec3::UnitY()};
      target.push_W_n = Vec3(0, 0, -press_n);
      finger.set_target(target);
      double most_n = 0, landed_s = -1;
      TickRecord row;
      for (int k = 0; k < 12000; ++k) {
        row = touch.tick(finger.advance(dt_s));
        finger.feel(row);
        most_n = std::max(most_n, row.normal_force_n);
        if (landed_s < 0 && row.walls > 0) landed_s = dt_s * k;
      }
      EXPECT_LT(most_n, 1.3 * press_n);
      EXPECT_NEAR(row.normal_force_n, press_n, 0.2 * press_n);
      EXPECT_GT(landed_s, 0);
      EXPECT_LT(landed_s, 1) << "and in time";
    }
  }
}

// Pressed all the while, it is dragged off a step of 30 mm.
TEST(HandFinger, LandsSoftlyBelowALedge) {
  Scene scene = test::plane_scene("none");
  scene.motion.rate_hz = 4000;
  const double dt_s = 1 / scene.motion.rate_hz, ledge_m = 0.03, press_n = 1;
  World lower = *test::plane_world();
  lower.surfaces[0].plane_point_W.z() = -ledge_m;
  HandSettings hand;
  hand.encoder_m = 0;
  HandFinger finger({scene, nullptr, {0, Vec3(0, 0, 0.01), Vec3::UnitY()}, {}, hand}, dt_s);
  Touch above(test::plane_world(), scene), below(std::make_shared<World>(lower), scene);
  FingerSample target{0, Vec3(0, 0, scene.finger.radius_m), Vec3::UnitY()};
  target.push_W_n = Vec3(0, 0, -press_n);
  finger.set_target(target);
  const auto most_n = [&](Touch& touch, double seconds) {
    double most_n = 0;
    for (int k = 0; k * dt_s < seconds; ++k) {
      const TickRecord row = touch.tick(finger.advance(dt_s));
      finger.feel(row);
      most_n = std::max(most_n, row.normal_force_n);
    }
    return most_n;
  };
  most_n(above, 2);
  target.p_WQ.z() -= ledge_m;
  finger.set_target(target);
  EXPECT_LT(most_n(below, 1), 1.3 * press_n);
  const double at_rest_n = most_n(below, 0.2);
  EXPECT_NEAR(at_rest_n, press_n, 0.2 * press_n) << "and in time";
}

/// What a pointer on its way did to a hand of defaults over a shipped scene. In the end it rests for long
/// enough that a hand that was led round an edge flies and lands.
test::PointerRun walk(const std::string& name, std::uint64_t seed, double press_n) {
  Scene scene = read_scene_file((test::source_dir() / "scenes" / (name + ".toml")).string()).scene;
  scene.hand.reset();
  const test::PointedWorld pointed(name, scene, load_world(scene));
  test::PointerWalk walk(pointed, seed, press_n);
  HandFinger finger({scene, pointed.world, walk.start(), {}, HandSettings{}}, 1 / scene.motion.rate_hz);
  return walk.run(finger, 1.2, press_n > 0 ? 3 : 1.2);
}

const int walk_count = test::sanitized() ? 1 : 12;

// Drawn along by its weak spring alone it would swing into rims.
TEST(HandFinger, HoversWithoutTouching) {
  int there = 0;
  for (int k = 0; k < walk_count; ++k) {
    for (const char* name : {"housing", "bracket"}) {
      SCOPED_TRACE(testing::Message() << "path " << k << " over " << name);
      const test::PointerRun run = walk(name, 5000 + static_cast<std::uint64_t>(k), 0);
      EXPECT_EQ(run.touched, 0) << "up to " << run.most_n << " N";
      there += run.last_off_m < 0.01 ? 1 : 0;
    }
  }
  if (test::sanitized()) return;  // of so few walks hardly any may end where they are wanted
  EXPECT_GT(there, walk_count) << "and comes to where it is wanted, of " << 2 * walk_count;
}

TEST(HandFinger, PressesNoHarderThanTheScenesGreatest) {
  int pressed = 0;
  for (int k = 0; k < walk_count; ++k) {
    for (const char* name : {"housing", "bracket"}) {
      for (const double press_n : {1.0, 5.0}) {
        SCOPED_TRACE(testing::Message() << "path " << k << " over " << name << " with " << press_n << " N");
        const test::PointerRun run = walk(name, 6000 + static_cast<std::uint64_t>(k), press_n);
        EXPECT_LE(run.most_n, 10);
        pressed += run.last_n > 0.5 * press_n ? 1 : 0;
      }
    }
  }
  EXPECT_GT(pressed, 2 * walk_count) << "of " << 4 * walk_count;
}

TEST(HandFinger, SaysWhichHandItTakesWhereTheSceneHasNone) {
  const Scene scene = test::plane_scene("none");
  EXPECT_NE(HandFinger({scene, nullptr, {}}, 1e-3).opening_words().find("no [hand]"), std::string::npos);
  EXPECT_EQ(HandFinger({scene, nullptr, {}, {}, HandSettings{}}, 1e-3).opening_words(), "");
}

}  // namespace
}  // namespace fingerpad::hand_finger_test
