#include "motion/placed_motion.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

namespace fingerpad::placed_motion_test {
namespace {

const Vec3 moved_m(1, 2, 3);

Mat3 quarter_turn() {
  return Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitZ()).toRotationMatrix();
}

Points one(double x, double y, double z) {
  return Vec3(x, y, z);
}

TEST(PlacedMotion, TurnsAllThatARecordingSaysAndMovesItsPlaces) {
  Motion motion;
  motion.t_s = {0};
  motion.p_WQ = one(1, 0, 5);
  motion.direction_W = one(0, 1, 0);
  motion.push_W_n = one(2, 0, 0);
  motion.velocity_W = one(0, 3, 1);
  motion.force_W_n = one(4, 0, 1);
  motion.attitude = {Attitude::Identity()};
  motion.normal_force_n = {7};
  place(motion, quarter_turn(), moved_m);
  const auto expect = [](const Points& points, const Vec3& due) {
    ASSERT_EQ(points.cols(), 1);
    EXPECT_LT((points.col(0) - due).norm(), 1e-15) << points.transpose();
  };
  expect(motion.p_WQ, Vec3(1, 3, 8));
  expect(motion.direction_W, Vec3(-1, 0, 0));
  expect(motion.push_W_n, Vec3(0, 2, 0));
  expect(motion.velocity_W, Vec3(-3, 0, 1));
  expect(motion.force_W_n, Vec3(0, 4, 1));
  expect(motion.attitude[0] * Vec3(1, 0, 0), Vec3(0, 1, 0));
  EXPECT_EQ(motion.normal_force_n[0], 7);
}

TEST(PlacedMotion, WhatARecordingDoesNotSayStaysUnsaid) {
  Motion motion;
  motion.t_s = {0};
  motion.p_WQ = one(1, 0, 0);
  place(motion, quarter_turn(), moved_m);
  EXPECT_EQ(motion.direction_W.cols(), 0);
  EXPECT_EQ(motion.force_W_n.cols(), 0);
  EXPECT_TRUE(motion.attitude.empty());
}

TEST(PlacedMotion, AScriptedOneGoesTheSameWayThere) {
  ScriptedMotion circle;
  circle.kind = ScriptedMotion::Kind::circle;
  circle.centre_m = Vec3(0.1, 0.2, 0.3);
  circle.normal = Vec3(0, 0.6, 0.8);
  circle.amplitude_m = 0.05;
  circle.frequency_hz = 1;
  ScriptedMotion line;
  line.kind = ScriptedMotion::Kind::line;
  line.to_m = Vec3(1, 2, 3);
  line.duration_s = 1;
  for (const ScriptedMotion& before : {circle, line}) {
    ScriptedMotion after = before;
    place(after, quarter_turn(), moved_m);
    for (const double t_s : {0.0, 0.3, 0.9})
      EXPECT_LT((after.at(t_s) - (quarter_turn() * before.at(t_s) + moved_m)).norm(), 1e-14);
  }
}

}  // namespace
}  // namespace fingerpad::placed_motion_test
