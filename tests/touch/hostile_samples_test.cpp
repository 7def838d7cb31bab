// A tick never gives a force that is not finite, whatever its sample and whatever a scene may say.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "base/random_stream.hpp"
#include "contact/contact_method_table.hpp"
#include "friction/law_table.hpp"
#include "scene/scene.hpp"
#include "support/shapes.hpp"
#include "support/worlds.hpp"
#include "touch/closed_loop.hpp"
#include "touch/touch.hpp"

namespace fingerpad::hostile_samples_test {
namespace {

double hostile_number(RandomStream& random) {
  static const double kinds[] = {0,
                                 5e-324,
                                 1e-310,
                                 1e-150,
                                 1e-12,
                                 1e-3,
                                 0.009,
                                 0.0101,
                                 0.3,
                                 1,
                                 1e3,
                                 1e9,
                                 1e18,
                                 1e20,
                                 1e35,
                                 4e38,
                                 1e59,
                                 1e61,
                                 1e100,
                                 1e154,
                                 1e200,
                                 1e308,
                                 std::numeric_limits<double>::max(),
                                 std::numeric_limits<double>::infinity(),
                                 std::nan("")};
  const double magnitude = kinds[static_cast<std::size_t>(random.uniform() * std::size(kinds))];
  return random.uniform() < 0.5 ? -magnitude : magnitude;
}

/// Mostly on the 2 cm box, where there is something to be felt.
Vec3 hostile_position(RandomStream& random) {
  Vec3 p = 0.011 * Vec3(2 * random.uniform() - 1, 2 * random.uniform() - 1, 2 * random.uniform() - 1);
  if (random.uniform() < 0.5) return p;
  for (int i = 0; i < 3; ++i) {
    if (random.uniform() < 0.5) p[i] = hostile_number(random);
  }
  return p;
}

Vec3 hostile_vector(RandomStream& random) {
  return {hostile_number(random), hostile_number(random), hostile_number(random)};
}

void expect_sound(const TickRecord& row) {
  ASSERT_TRUE(row.force_W_n.allFinite()) << row.force_W_n.transpose();
  ASSERT_TRUE(row.friction_W_n.allFinite());
  ASSERT_TRUE(std::isfinite(row.normal_force_n) && row.normal_force_n >= 0);
  ASSERT_TRUE(std::isfinite(row.depth_m) && row.depth_m >= 0);
  ASSERT_TRUE(std::isfinite(row.mu));
  if (row.phase == Phase::free) return;
  ASSERT_TRUE(row.contact_W.allFinite() && row.normal_W.allFinite());
  ASSERT_NEAR(row.normal_W.norm(), 1, 1e-9);
}

void tick_with_anything(const std::shared_ptr<const World>& world, const Scene& scene, int ticks) {
  Touch touch(world, scene);
  RandomStream random(5);
  for (int k = 0; k < ticks; ++k) {
    FingerSample sample{k % 7 == 0 ? hostile_number(random) : k * 1e-3, hostile_position(random),
                        k % 3 == 0 ? hostile_vector(random) : Vec3(0, 0.6, -0.8)};
    if (k % 5 == 0) sample.push_W_n = hostile_vector(random);
    expect_sound(touch.tick(sample));
    if (testing::Test::HasFatalFailure()) return;
  }
}

std::shared_ptr<const World> box_and_plane(const SurfaceProperties& properties) {
  auto world = std::make_shared<World>(*test::world_of(test::box_soup(Vec3(0.02, 0.02, 0.02))));
  Surface plane;
  plane.plane_point_W = Vec3(0, 0, -0.5);
  world->surfaces.push_back(plane);
  for (Surface& surface : world->surfaces) {
    surface.properties = properties;
    if (surface.tree) surface.tree->prepare_curved();
  }
  return world;
}

TEST(HostileSamples, EveryLawAnswersWithFiniteForces) {
  for (const SurfaceProperties& properties :
       {SurfaceProperties{}, SurfaceProperties{1e9, 1e9, 1000, 1000}, SurfaceProperties{1e-6, 0, 1e-300, 0},
        SurfaceProperties{1e9, 0, 0, 0}}) {
    const auto world = box_and_plane(properties);
    for (const LawEntry& law : law_table()) {
      for (const ContactMethodEntry& method : contact_method_table()) {
        Scene scene = test::plane_scene(std::string(law.name));
        scene.contact.method = method.name;
        tick_with_anything(world, scene, 600);
        ASSERT_FALSE(HasFatalFailure()) << law.name << " stiffness " << properties.stiffness_n_per_m;
      }
    }
  }
}

TEST(HostileSamples, EveryNormalAndRadiusAndRateAnswersWithFiniteForces) {
  const auto world = box_and_plane({});
  for (const Normals normals : normals_table()) {
    for (const double radius_m : {0.0, 0.004, 1000.0}) {
      for (const double rate_hz : {1.0, 1e6}) {
        Scene scene = test::plane_scene("finger-pad");
        scene.contact.method = radius_m > 1 ? "closest-point" : "proxy";
        scene.contact.normals = normals;
        scene.finger.radius_m = radius_m;
        scene.motion.rate_hz = rate_hz;
        scene.friction.vibration = VibrationSettings{1e-3, 1e-3, 1, 1};
        tick_with_anything(world, scene, 600);
        ASSERT_FALSE(HasFatalFailure()) << "radius " << radius_m << " rate " << rate_hz;
      }
    }
  }
}

TEST(HostileSamples, NumbersOfALawAtTheirBoundsGiveFiniteForces) {
  const auto world = box_and_plane({});
  for (const LawEntry& law : law_table()) {
    for (const LawParameter& parameter : law.parameters) {
      for (const double bound : {std::max(parameter.min, 1e-12), std::min(parameter.max, 1e12)}) {
        Scene scene = test::plane_scene(std::string(law.name));
        scene.friction.settings.numbers[std::string(parameter.key)] = bound;
        try {
          tick_with_anything(world, scene, 200);
        } catch (const Error&) {
          continue;  // numbers that do not go together are refused
        }
        ASSERT_FALSE(HasFatalFailure()) << law.name << " " << parameter.key << " = " << bound;
      }
    }
  }
}

ClosedLoop loop_of(const HandSettings& hand, double stiffness_n_per_m, const Vec3& to_m) {
  auto world = std::make_shared<World>(*test::plane_world());
  world->surfaces.front().properties.stiffness_n_per_m = stiffness_n_per_m;
  Scene scene = test::plane_scene("coulomb");
  scene.hand = hand;
  ScriptedMotion press;
  press.kind = ScriptedMotion::Kind::line;
  press.from_m = Vec3(0, 0, 0.001);
  press.to_m = to_m;
  press.duration_s = 20;
  return {world, scene, FingerPath(press, 1000, Vec3(0, 0.6, -0.8))};
}

TEST(ClosedLoop, SaysThatItDivergedAndWhichStiffnessItWouldHold) {
  ClosedLoop loop = loop_of({}, 1e6, Vec3(0, 0, -0.005));
  long ticks = 0;
  for (; ticks < loop.tick_count() && !loop.has_diverged(); ++ticks) {
    const TickRecord row = loop.next();
    ASSERT_TRUE(row.p_WQ.allFinite());
    ASSERT_TRUE(row.force_W_n.allFinite());
  }
  ASSERT_TRUE(loop.has_diverged());
  EXPECT_LT(ticks, loop.tick_count());
  // SCIENCE 4: 2 b/T is 1000 N/m, the finger's inertia gives a thousandth more.
  EXPECT_NE(loop.divergence().find("stiffness_n_per_m 1000000 is above 1001 N/m"), std::string::npos)
      << loop.divergence();
}

TEST(ClosedLoop, AStableHandDoesNotDiverge) {
  ClosedLoop loop = loop_of({}, 900, Vec3(0, 0, -0.005));
  for (long k = 0; k < loop.tick_count(); ++k) loop.next();
  EXPECT_FALSE(loop.has_diverged());
}

TEST(ClosedLoop, AHandWhoseMotionIsNoNumberHasDiverged) {
  ClosedLoop loop = loop_of({.mass_kg = 1e-300}, 1000, Vec3(0, 0, -0.005));
  for (int k = 0; k < 100 && !loop.has_diverged(); ++k) loop.next();
  ASSERT_TRUE(loop.has_diverged());
  EXPECT_NE(loop.divergence().find("the hand's loop diverged"), std::string::npos);
}

TEST(SimulatedHand, AQuantumTooSmallForADoubleIsNone) {
  HandSettings settings;
  settings.encoder_m = 1e-300;
  SimulatedHand hand(settings, 1e-3);
  hand.start(Vec3(1e9, 0.1, -3));
  EXPECT_EQ(hand.encoded_W(), Vec3(1e9, 0.1, -3));
}

}  // namespace
}  // namespace fingerpad::hostile_samples_test
