#include "study/motion_stretches.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "scene/scene.hpp"
#include "support/worlds.hpp"

namespace fingerpad::motion_stretches_test {
namespace {

/// Up and down through z = 0 once every two seconds, in contact for half of the time.
FingerPath tapping(double seconds) {
  ScriptedMotion motion;
  motion.kind = ScriptedMotion::Kind::sine;
  motion.direction = Vec3::UnitZ();
  motion.amplitude_m = 1e-3;
  motion.frequency_hz = 0.5;
  motion.duration_s = seconds;
  return {motion, 1000, Vec3(0, 0.6, -0.8)};
}

bool is_free(const FingerPath& path, double t_s) {
  return path.at_time(t_s).p_WQ.z() >= 0;
}

TEST(MotionStretches, AreTheWholeOfAShortMotion) {
  const FingerPath path = tapping(14.3);
  const auto stretches = motion_stretches(test::plane_world(), test::plane_scene("stick-slip"), path);
  ASSERT_EQ(stretches.size(), 1u);
  EXPECT_EQ(stretches[0].start_s, 0);
  EXPECT_EQ(stretches[0].counted_s, 0);
  EXPECT_EQ(stretches[0].end_s, 14.3);
}

TEST(MotionStretches, OfALongOneBeginWithAFreeFinger) {
  const FingerPath path = tapping(300);
  const auto stretches = motion_stretches(test::plane_world(), test::plane_scene("stick-slip"), path);
  ASSERT_EQ(stretches.size(), 10u);
  double counted_s = 0;
  int in_contact = 0;
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    const MotionStretch& s = stretches[i];
    EXPECT_TRUE(is_free(path, s.start_s)) << i;
    in_contact += is_free(path, s.counted_s) ? 0 : 1;
    EXPECT_LT(s.counted_s - s.start_s, 1.01) << i;  // no longer than a tap, and a tick
    EXPECT_GE(s.counted_s, 30 * static_cast<double>(i)) << i;
    EXPECT_LE(s.end_s, 30 * static_cast<double>(i + 1)) << i;
    // On every rate's ticks.
    EXPECT_NEAR(std::remainder((s.counted_s - s.start_s) * 250, 1), 0, 1e-6) << i;
    counted_s += s.end_s - s.counted_s;
  }
  EXPECT_NEAR(counted_s, compared_s, 1e-9);
  EXPECT_GT(in_contact, 0);  // some needed their lead-in
}

TEST(MotionStretches, AreDrawnWithTheScenesSeed) {
  const FingerPath path = tapping(300);
  Scene scene = test::plane_scene("stick-slip");
  const auto first = motion_stretches(test::plane_world(), scene, path);
  EXPECT_EQ(motion_stretches(test::plane_world(), scene, path)[3].counted_s, first[3].counted_s);
  scene.seed = 2;
  EXPECT_NE(motion_stretches(test::plane_world(), scene, path)[3].counted_s, first[3].counted_s);
}

TEST(MotionStretches, OfAFingerThatNeverLeavesLeadInForHalfASecond) {
  ScriptedMotion motion;
  motion.kind = ScriptedMotion::Kind::sine;
  motion.centre_m = Vec3(0, 0, -1e-3);
  motion.direction = Vec3::UnitX();
  motion.amplitude_m = 1e-3;
  motion.frequency_hz = 1;
  motion.duration_s = 100;
  const FingerPath path(motion, 1000, Vec3(0, 0.6, -0.8));
  for (const MotionStretch& s : motion_stretches(test::plane_world(), test::plane_scene("stick-slip"), path))
    EXPECT_NEAR(s.counted_s - s.start_s, 0.5, 1e-9);
}

}  // namespace
}  // namespace fingerpad::motion_stretches_test
