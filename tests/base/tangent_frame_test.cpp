#include "base/tangent_frame.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "base/random_stream.hpp"

namespace fingerpad::tangent_frame_test {
namespace {

// A handful of double operations on numbers of size 1.
constexpr double rounding = 1e-14;

Vec3 random_unit(RandomStream& random) {
  return Vec3(random.normal(), random.normal(), random.normal()).normalized();
}

TEST(TangentFrame, IsRightHandedAndOrthonormal) {
  RandomStream random(7);
  for (int i = 0; i < 200; ++i) {
    const Vec3 n = random_unit(random);
    const Mat3 frame = tangent_frame(n, random_unit(random));
    EXPECT_LT((frame.transpose() * frame - Mat3::Identity()).norm(), 10 * rounding);
    EXPECT_NEAR(frame.determinant(), 1, rounding);
    EXPECT_LT((frame.col(2) - n).norm(), rounding);
  }
}

TEST(TangentFrame, TakesItsSecondAxisFromTheGivenDirection) {
  const Mat3 frame = tangent_frame(Vec3::UnitZ(), Vec3(0, 3, -4));
  EXPECT_LT((frame.col(1) - Vec3::UnitY()).norm(), rounding);
}

TEST(TangentFrame, IsWholeWhereTheDirectionLiesAlongTheNormal) {
  const Mat3 frame = tangent_frame(Vec3::UnitZ(), Vec3::UnitZ());
  EXPECT_LT((frame.transpose() * frame - Mat3::Identity()).norm(), rounding);
}

TEST(Transport, AroundAClosedLoopOnASphereTurnsByTheEnclosedSolidAngle) {
  // Gauss-Bonnet: a loop at polar angle theta encloses 2 pi (1 - cos theta).
  const double theta = 0.6;
  const auto normal_at = [theta](double phi) {
    return Vec3(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
  };
  const Mat3 start = tangent_frame(normal_at(0), Vec3::UnitZ());
  Mat3 frame = start;
  const int steps = 20000;
  for (int i = 1; i <= steps; ++i) frame = transported(frame, normal_at(2 * std::numbers::pi * i / steps));
  const double turned = std::atan2(frame.col(1).dot(start.col(0)), frame.col(1).dot(start.col(1)));
  const double enclosed = 2 * std::numbers::pi * (1 - std::cos(theta));
  // Small rotations over chords err by (2 pi / steps)^2 a turn.
  EXPECT_NEAR(std::abs(turned), enclosed, 1e-6);
}

TEST(Transport, DoesNotFlipWhenTheNormalPassesTheFingerDirection) {
  // The frame is turned from tick to tick; one rebuilt from an axis would jump where the normal meets it.
  Mat3 frame = tangent_frame(Vec3(0.1, 0, -1).normalized(), Vec3(0, 0, -1));
  Vec3 last = frame.col(1);
  for (int i = 1; i <= 200; ++i) {
    frame = transported(frame, Vec3(0.1 - 0.001 * i, 0, -1).normalized());
    EXPECT_LT((frame.col(1) - last).norm(), 2e-3) << i;  // the normal itself turns by 1e-3 a step
    last = frame.col(1);
  }
}

TEST(Transport, StandsAnOppositeNormal) {
  const Mat3 frame = transported(tangent_frame(Vec3::UnitZ(), Vec3::UnitX()), -Vec3::UnitZ());
  EXPECT_LT((frame.transpose() * frame - Mat3::Identity()).norm(), rounding);
  EXPECT_LT((frame.col(2) + Vec3::UnitZ()).norm(), rounding);
}

TEST(SurfaceDisplacement, IsTheDifferenceOnAPlane) {
  const Vec3 n = Vec3(1, 2, 3).normalized();
  const Vec3 d =
      tangent_frame(n, Vec3::UnitX()).col(0) * 0.01 + tangent_frame(n, Vec3::UnitX()).col(1) * 0.02;
  const Vec3 c(5, 6, 7);
  EXPECT_LT((surface_displacement(c, n, c + d, n) - d).norm(), rounding);
}

TEST(SurfaceDisplacement, IsTheArcOnACylinderAlongAroundAndAslant) {
  const double radius = 0.003;
  const auto point = [radius](double angle, double along) {
    return Vec3(radius * std::cos(angle), radius * std::sin(angle), along);
  };
  const auto normal = [](double angle) { return Vec3(std::cos(angle), std::sin(angle), 0); };
  for (const double angle : {1e-7, 0.01, 0.5, 1.5, 3.0}) {
    const Vec3 d = surface_displacement(point(0, 0), normal(0), point(angle, 0.001), normal(angle));
    const Vec3 around(-std::sin(angle), std::cos(angle), 0);
    EXPECT_NEAR(d.dot(around), radius * angle, 1e-12 * radius) << angle;
    EXPECT_NEAR(d.z(), 0.001, 1e-15) << angle;
    EXPECT_NEAR(d.dot(normal(angle)), 0, 1e-15) << angle;
  }
}

TEST(SurfaceDisplacement, StaysFiniteForOppositeNormals) {
  const Vec3 d = surface_displacement(Vec3(0, 0, 1), Vec3::UnitZ(), Vec3(0, 0, -1), -Vec3::UnitZ());
  EXPECT_TRUE(d.allFinite());
}

TEST(SurfaceDisplacement, HasNoSeamWhereItsSeriesEnd) {
  // A cylinder's helix; the series serve below sin(phi/2) = 0.01.
  for (double angle = 1e-12; angle < 0.1; angle *= 1.07) {
    const Vec3 c(1, 0, 0), s(std::cos(angle), std::sin(angle), 0.3 * angle);
    const Vec3 normal_s(std::cos(angle), std::sin(angle), 0);
    const Vec3 expected(-std::sin(angle) * angle, std::cos(angle) * angle, 0.3 * angle);
    // The chord's own rounding is that of coordinates near 1.
    EXPECT_LT((surface_displacement(c, Vec3::UnitX(), s, normal_s) - expected).norm(), 3e-16) << angle;
  }
}

TEST(Transport, TurnsByTheSmallestRotation) {
  RandomStream random(3);
  for (int i = 0; i < 200; ++i) {
    const Vec3 a = random_unit(random), b = random_unit(random);
    const Mat3 frame = tangent_frame(a, random_unit(random));
    const Mat3 expected = Eigen::Quaterniond::FromTwoVectors(a, b).toRotationMatrix() * frame;
    EXPECT_LT((transported(frame, b) - expected).norm(), 1e-13);  // near-opposite pairs divide by 1 + cos
  }
}

}  // namespace
}  // namespace fingerpad::tangent_frame_test
