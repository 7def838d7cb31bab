// What a motion says of the finger better than its positions do: the measured normal force, the velocity.
#include <gtest/gtest.h>

#include <limits>

#include "scene/scene.hpp"
#include "support/worlds.hpp"
#include "touch/closed_loop.hpp"
#include "touch/touch.hpp"

namespace fingerpad::measured_test {
namespace {

using test::plane_scene;
using test::plane_world;

FingerSample pressed(long k, const Vec3& p, double normal_force_n) {
  FingerSample sample;
  sample.t_s = static_cast<double>(k) / 1000;
  sample.p_WQ = p;
  sample.normal_force_n = normal_force_n;
  return sample;
}

TEST(Measured, NormalForceStandsInPlaceOfTheModels) {
  Touch touch(plane_world(), plane_scene("coulomb"));
  touch.tick(pressed(0, {0, 0, -0.001}, 2.5));
  // The model would press with 1 N.
  const TickRecord row = touch.tick(pressed(1, {0.001, 0, -0.001}, 2.5));
  EXPECT_EQ(row.normal_force_n, 2.5);
  EXPECT_NEAR(row.friction_W_n.norm(), 0.2 * 2.5, 1e-12);
  EXPECT_NEAR(row.force_W_n.z(), 2.5, 1e-15);
  EXPECT_NEAR(row.mu, 0.2, 1e-12);
  EXPECT_EQ(row.depth_m, 0.001);
}

TEST(Measured, NormalForceThatDoesNotPressIsNone) {
  for (const double none_n : {0.0, -3.0, std::numeric_limits<double>::quiet_NaN(), 1e300}) {
    Touch touch(plane_world(), plane_scene("finger-pad"));
    touch.tick(pressed(0, {0, 0, -0.001}, none_n));
    const TickRecord row = touch.tick(pressed(1, {0.001, 0, -0.001}, none_n));
    EXPECT_EQ(row.normal_force_n, 0) << none_n;
    EXPECT_EQ(row.force_W_n, Vec3::Zero()) << none_n;
    EXPECT_NE(row.phase, Phase::free) << "the finger is there all the same";
  }
}

TEST(Measured, NormalForceInTheAirIsNone) {
  Touch touch(plane_world(), plane_scene("finger-pad"));
  const TickRecord row = touch.tick(pressed(0, {0, 0, 0.001}, 2));
  EXPECT_EQ(row.phase, Phase::free);
  EXPECT_EQ(row.normal_force_n, 0);
}

TEST(Measured, VelocityIsWhatTheLawSees) {
  // 0.2 m/s by two positions, 0.02 m/s as it is known: below the v_min of 0.1 m/s the pad that slips sticks.
  const auto phase_at = [](std::optional<Vec3> velocity_W) {
    Touch touch(plane_world(), plane_scene("stick-slip"));
    FingerSample sample;
    for (long k = 0; k < 20; ++k) {
      sample.p_WQ = Vec3(2e-4 * static_cast<double>(k), 0, -0.001);
      touch.tick(sample);
    }
    sample.p_WQ.x() += 2e-4;
    sample.velocity_W = velocity_W;
    return touch.tick(sample).phase;
  };
  EXPECT_EQ(phase_at({}), Phase::slip);
  EXPECT_EQ(phase_at(Vec3(0.2, 0, 0)), Phase::slip);
  EXPECT_EQ(phase_at(Vec3(0.02, 0, 0)), Phase::stick);
  EXPECT_EQ(phase_at(Vec3(1e300, 0, 0)), Phase::slip) << "no velocity";
}

TEST(Measured, ALoopGoesAtItsPathsRate) {
  Motion motion;
  motion.t_s = {0, 0.5};
  motion.p_WQ.resize(3, 2);
  motion.p_WQ << 0, 0.05, 0, 0, -0.001, -0.001;
  Scene scene = plane_scene("coulomb");  // says 1000 Hz
  auto world = std::make_shared<World>(*plane_world());
  world->surfaces[0].properties.damping_n_s_per_m = 10;
  motion.p_WQ(2, 1) = -0.002;
  ClosedLoop loop(world, scene, FingerPath(motion, 100, Vec3::UnitX()));
  ASSERT_EQ(loop.tick_count(), 51);
  loop.next();
  // Depth 1.02 mm, reached at 2 mm/s, of which a tick of 1 ms would make 20 mm/s.
  EXPECT_NEAR(loop.next().normal_force_n, 1.02 + 10 * 0.002, 1e-12);
}

}  // namespace
}  // namespace fingerpad::measured_test
