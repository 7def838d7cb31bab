#include "motion/finger_path.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>

#include "base/error.hpp"
#include "support/paths.hpp"

namespace fingerpad::finger_path_test {
namespace {

Motion read(const std::string& text) {
  const auto path = test::scratch_dir() / "m.csv";
  std::ofstream(path) << text;
  return read_motion_csv(path.string());
}

std::string refusal(const std::string& text) {
  try {
    read(text);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::refused);
    return error.what();
  }
  return "";
}

TEST(FingerPath, FindsItsSamplesOnAnyClock) {
  // Even, uneven, and one with a gap: each time lies where a search from end to end has it.
  std::string uneven = "t_s,x_m,y_m,z_m\n";
  std::vector<double> times;
  for (int i = 0; i < 50; ++i) times.push_back(0.001 * i * i + (i > 30 ? 7 : 0));
  for (std::size_t i = 0; i < times.size(); ++i)
    uneven += std::to_string(times[i]) + "," + std::to_string(i) + ",0,0\n";
  const FingerPath path(read(uneven), 1000, Vec3::UnitX());
  for (std::size_t i = 0; i + 1 < times.size(); ++i) {
    const double middle_s = (times[i] + times[i + 1]) / 2;
    EXPECT_NEAR(path.at_time(middle_s).p_WQ.x(), static_cast<double>(i) + 0.5, 1e-9);
    EXPECT_NEAR(path.at_time(times[i]).p_WQ.x(), static_cast<double>(i), 1e-9);
  }
  EXPECT_EQ(path.at_time(-1).p_WQ.x(), 0);
  EXPECT_EQ(path.at_time(1e9).p_WQ.x(), 49);
}

TEST(FingerPath, GoesAsAnotherWhereEveryPlaceIsTheSame) {
  const std::string header = "t_s,x_m,y_m,z_m,dx,dy,dz\n", first = "0,0,0,0,1,0,0\n";
  const FingerPath path(read(header + first + "1,1,0,0,1,0,0\n"), 100, Vec3::UnitX());
  const auto goes_as = [&](const std::string& second, double rate_hz) {
    return path.goes_as(FingerPath(read(header + first + second), rate_hz, Vec3::UnitX()));
  };
  EXPECT_TRUE(path.goes_as(path));
  EXPECT_TRUE(goes_as("1,1,0,0,1,0,0\n", 100)) << "read twice";
  EXPECT_TRUE(goes_as("1,1,0,0,0,1,0\n", 100)) << "a finger that lies otherwise";
  EXPECT_FALSE(goes_as("1,1,0,0,1,0,0\n", 200));
  EXPECT_FALSE(goes_as("1,1,0,1e-9,1,0,0\n", 100));
  EXPECT_FALSE(goes_as("1.001,1,0,0,1,0,0\n", 100));
  ScriptedMotion scripted;
  scripted.duration_s = 1;
  const FingerPath sine(scripted, 100, Vec3::UnitX());
  EXPECT_FALSE(path.goes_as(sine));
  EXPECT_TRUE(sine.goes_as(sine));
  scripted.amplitude_m = 1;
  EXPECT_FALSE(sine.goes_as(FingerPath(scripted, 100, Vec3::UnitX())));
}

TEST(FingerPath, HasATickAtBothEnds) {
  const FingerPath path(read("t_s,x_m,y_m,z_m\n0,0,0,0\n0.2,1,0,0\n"), 1000, Vec3::UnitX());
  EXPECT_EQ(path.tick_count(), 201);  // 0.2 * 1000 rounds below 200 in some arithmetics: the contract's 1e-6
  EXPECT_DOUBLE_EQ(path.at(200).t_s, 0.2);
  EXPECT_DOUBLE_EQ(path.at(200).p_WQ.x(), 1);
}

TEST(FingerPath, DropsWhatIsLeftAfterTheLastWholeTick) {
  const FingerPath path(read("t_s,x_m,y_m,z_m\n1,0,0,0\n1.0035,7,0,0\n"), 1000, Vec3::UnitX());
  EXPECT_EQ(path.tick_count(), 4);
  EXPECT_DOUBLE_EQ(path.at(0).t_s, 1);
}

TEST(FingerPath, InterpolatesLinearlyAndHitsTheSamplesExactly) {
  const FingerPath path(read("t_s,x_m,y_m,z_m\n0,0,0,0\n0.01,0.3,0,0\n0.03,0.1,5,0\n"), 1000, Vec3::UnitX());
  EXPECT_EQ(path.at(10).p_WQ, Vec3(0.3, 0, 0));
  EXPECT_NEAR(path.at(5).p_WQ.x(), 0.15, 1e-16);
  EXPECT_NEAR(path.at(20).p_WQ.x(), 0.2, 1e-15);
  EXPECT_EQ(path.at(30).p_WQ, Vec3(0.1, 5, 0));
}

TEST(FingerPath, KeepsDirectionsUnitBetweenSamples) {
  const FingerPath path(read("t_s,x_m,y_m,z_m,dx,dy,dz\n0,0,0,0,2,0,0\n0.01,0,0,0,0,0,3\n"), 1000,
                        Vec3::UnitY());
  EXPECT_NEAR(path.at(5).direction_W.norm(), 1, 1e-15);
  EXPECT_NEAR(path.at(5).direction_W.x(), std::sqrt(0.5), 1e-15);
}

TEST(FingerPath, TurnsAlongTheShortestWayBetweenAttitudes) {
  // A quarter turn about z, the second quaternion of the other sign: it is the same attitude.
  const FingerPath path(read("t_s,x_m,y_m,z_m,qw,qx,qy,qz\n0,0,0,0,1,0,0,0\n"
                             "0.01,0,0,0,-0.70710678,0,0,-0.70710678\n"),
                        1000, Vec3::UnitX());
  const FingerSample half = path.at(5);
  ASSERT_TRUE(half.attitude.has_value());
  EXPECT_NEAR(std::abs(half.attitude->w()), std::cos(std::numbers::pi / 8), 1e-9);
  EXPECT_NEAR(half.attitude->norm(), 1, 1e-15);
  // Without dx, dy, dz the scene's direction turns with the finger.
  EXPECT_NEAR((half.direction_W - Vec3(std::sqrt(0.5), std::sqrt(0.5), 0)).norm(), 0, 1e-8);
}

TEST(FingerPath, KeepsDirectionsBesideAttitudes) {
  const FingerPath path(read("t_s,x_m,y_m,z_m,dx,dy,dz,qw,qx,qy,qz\n0,0,0,0,0,0,-1,0,1,0,0\n"), 1000,
                        Vec3::UnitX());
  EXPECT_EQ(path.at(0).direction_W, Vec3(0, 0, -1));
  EXPECT_EQ(path.at(0).attitude->x(), 1);
}

TEST(FingerPath, RefusesAttitudesThatAreNone) {
  EXPECT_NE(refusal("t_s,x_m,y_m,z_m,qw,qx,qz\n0,0,0,0,1,0,0\n").find("all of qw, qx, qy and qz"),
            std::string::npos);
  EXPECT_NE(refusal("t_s,x_m,y_m,z_m,qw,qx,qy,qz\n0,0,0,0,1,0,0,0\n1,0,0,0,0.9,0,0,0\n")
                .find("m.csv:3: qw,qx,qy,qz is no unit quaternion: its length is 0.9"),
            std::string::npos);
  EXPECT_EQ(refusal("t_s,x_m,y_m,z_m,qw,qx,qy,qz\n0,0,0,0,1.0009,0,0,0\n"), "");
}

TEST(FingerPath, UsesTheSceneDirectionWhereTheMotionHasNone) {
  const FingerPath path(read("t_s,x_m,y_m,z_m\n0,0,0,0\n"), 1000, Vec3::UnitY());
  EXPECT_EQ(path.tick_count(), 1);
  EXPECT_EQ(path.at(0).direction_W, Vec3::UnitY());
}

TEST(FingerPath, RefusesAMotionOfAbsurdLength) {
  EXPECT_THROW(FingerPath(read("t_s,x_m,y_m,z_m\n0,0,0,0\n1e300,0,0,0\n"), 1000, Vec3::UnitY()), Error);
}

TEST(MotionTable, IsReadFromATraceToo) {
  const Motion motion = read("t_s,x_m,y_m,z_m,phase,cx_m\n0,1,2,3,free,nan\n0.1,1,2,4,stick,0.5\n");
  EXPECT_EQ(motion.t_s.size(), 2u);
  EXPECT_EQ(motion.p_WQ.col(1), Vec3(1, 2, 4));
  EXPECT_EQ(motion.direction_W.cols(), 0);
}

TEST(MotionTable, TellsTheLineOfWhatIsWrong) {
  EXPECT_NE(refusal("t_s,x_m,y_m,z_m\n0,0,0,0\n0,0,0,0\n").find("m.csv:3: time 0 s"), std::string::npos);
  EXPECT_NE(refusal("t_s,x_m,y_m,z_m\n").find("no rows"), std::string::npos);
  EXPECT_NE(refusal("t_s,x_m,y_m,z_m,dx\n0,0,0,0,1\n").find("all of dx, dy and dz"), std::string::npos);
  EXPECT_NE(refusal("t_s,x_m,y_m,z_m,dx,dy,dz\n0,0,0,0,0,0,0\n").find("m.csv:2: dx,dy,dz"),
            std::string::npos);
}

TEST(ScriptedMotion, SineCircleAndLineGoWhereTheirFormulasSay) {
  ScriptedMotion sine;
  sine.kind = ScriptedMotion::Kind::sine;
  sine.centre_m = Vec3(1, 0, 0);
  sine.direction = Vec3::UnitY();
  sine.amplitude_m = 0.02;
  sine.frequency_hz = 2;
  EXPECT_NEAR((sine.at(0.125) - Vec3(1, 0.02, 0)).norm(), 0, 1e-15);

  ScriptedMotion circle = sine;
  circle.kind = ScriptedMotion::Kind::circle;
  circle.normal = Vec3::UnitZ();
  for (const double t : {0.0, 0.1, 0.33}) EXPECT_NEAR((circle.at(t) - circle.centre_m).norm(), 0.02, 1e-15);
  EXPECT_NEAR((circle.at(0.125) - Vec3(0.98, 0, 0)).norm(), 0, 1e-15);

  ScriptedMotion line;
  line.kind = ScriptedMotion::Kind::line;
  line.from_m = Vec3(0, 0, 0);
  line.to_m = Vec3(0.1, 0, 0);
  line.speed_m_per_s = 0.05;
  line.duration_s = 2;
  EXPECT_NEAR(line.at(0.5).x(), 0.025, 1e-16);
}

}  // namespace
}  // namespace fingerpad::finger_path_test
