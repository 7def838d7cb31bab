#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <limits>

#include "base/error.hpp"
#include "motion/finger_path.hpp"
#include "support/paths.hpp"

namespace fingerpad::motion_bounds_test {
namespace {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;

std::string refusal_of(const std::string& rows) {
  const std::string path = (test::scratch_dir() / "wild.csv").string();
  std::ofstream(path) << "t_s,x_m,y_m,z_m\n" << rows;
  try {
    read_motion_csv(path);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::refused);
    return error.what();
  }
  return {};
}

TEST(MotionBounds, ACoordinateThatNoFingerReachesIsRefusedAtItsLine) {
  EXPECT_EQ(refusal_of("0,0,0,0\n1,1e9,-1e9,1e9\n"), "");
  EXPECT_THAT(refusal_of("0,0,0,0\n1,0,1e35,0\n"),
              AllOf(HasSubstr("wild.csv:3: y_m is 1e+35 m; a finger is at most"), HasSubstr("unit")));
  EXPECT_THAT(refusal_of("0,0,0,-1e308\n1,0,0,0\n"), HasSubstr("wild.csv:2: z_m is -1e+308 m"));
}

TEST(MotionBounds, ATimeThatNoClockShowsIsRefusedAtItsLine) {
  EXPECT_EQ(refusal_of("1700000000,0,0,0\n1700000001,0,0,0\n"), "");
  EXPECT_THAT(refusal_of("0,0,0,0\n1e12,0,0,0\n"), HasSubstr("wild.csv:3: time 1000000000000 s is beyond"));
}

TEST(MotionBounds, NoNumberThatIsNotFiniteIsASample) {
  const double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {inf, -inf, nan}) {
    EXPECT_NE(sample_fault(bad, Vec3::Zero()), "");
    for (int i = 0; i < 3; ++i) EXPECT_NE(sample_fault(0, bad * Vec3::Unit(i) + Vec3::Zero()), "");
  }
  EXPECT_EQ(sample_fault(0, Vec3::Zero()), "");
}

TEST(MotionBounds, APathKnowsHowFarItGoes) {
  Motion motion;
  motion.t_s = {0, 1};
  motion.p_WQ.resize(3, 2);
  motion.p_WQ << 1, 2, -3, 0, 0, 2.5;
  EXPECT_EQ(FingerPath(motion, 10, Vec3::UnitX()).farthest_m(), 3);
  ScriptedMotion circle;
  circle.kind = ScriptedMotion::Kind::circle;
  circle.centre_m = Vec3(0, -4, 0);
  circle.amplitude_m = 2;
  EXPECT_EQ(FingerPath(circle, 10, Vec3::UnitX()).farthest_m(), 6);
  ScriptedMotion line;
  line.kind = ScriptedMotion::Kind::line;
  line.to_m = Vec3(0, -4, 7);
  EXPECT_EQ(FingerPath(line, 10, Vec3::UnitX()).farthest_m(), 7);
}

TEST(MotionBounds, TooManyTicksAreRefusedWithTheirNumber) {
  Motion motion;
  motion.t_s = {0, 1e10};
  motion.p_WQ = Points::Zero(3, 2);
  try {
    FingerPath(motion, 1000, Vec3::UnitX());
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(),
                AllOf(HasSubstr("1e+13 ticks at 1000 Hz"), HasSubstr("is its time in seconds?")));
  }
}

}  // namespace
}  // namespace fingerpad::motion_bounds_test
