#include "motion/velocity_estimator.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace fingerpad::velocity_estimator_test {
namespace {

constexpr double quantum_m = 3e-5, dt_s = 1e-4;  // 0.03 mm at 10 kHz: a plain difference steps by 0.3 m/s

double rounded(double x) {
  return std::round(x / quantum_m) * quantum_m;
}

TEST(VelocityEstimator, IsThePlainDifferenceWithoutAQuantum) {
  VelocityEstimator estimator(0, 1e-3);
  EXPECT_EQ(estimator.next(Vec3(1, 2, 3)), Vec3::Zero());
  EXPECT_NEAR((estimator.next(Vec3(1.001, 2, 2.9)) - Vec3(1, 0, -100)).norm(), 0, 1e-9);
}

TEST(VelocityEstimator, ResolvesConstantSpeedsFarBelowTheQuantumAPerTick) {
  for (const double speed : {0.01, 0.05, 0.1, 0.2, 1.0}) {
    VelocityEstimator estimator(quantum_m, dt_s);
    double worst = 0;
    for (int k = 0; k < 5000; ++k) {
      const double v = estimator.next(Vec3(rounded(speed * k * dt_s), 0, 0)).x();
      if (k > 100) worst = std::max(worst, std::abs(v - speed));
    }
    // The ends of a window of n ticks are off by half a quantum each: quantum/(n T), n up to 64.
    EXPECT_LE(worst, quantum_m / (30 * dt_s)) << speed;
  }
}

TEST(VelocityEstimator, FollowsASineWhoseSpeedPassesVMin) {
  // 4 Hz, 10 mm: up to 0.25 m/s. The time at which the speed falls through 0.1 m/s must be right to a few ms.
  VelocityEstimator estimator(quantum_m, dt_s);
  const double omega = 2 * std::numbers::pi * 4;
  double squares = 0, plain_squares = 0, last = 0;
  const int n = 10000;
  for (int k = 0; k < n; ++k) {
    const double x = rounded(0.01 * std::sin(omega * k * dt_s));
    const double truth = 0.01 * omega * std::cos(omega * k * dt_s);
    const double v = estimator.next(Vec3(x, 0, 0)).x();
    if (k > 100) {
      squares += (v - truth) * (v - truth);
      plain_squares += ((x - last) / dt_s - truth) * ((x - last) / dt_s - truth);
    }
    last = x;
  }
  EXPECT_LT(std::sqrt(squares / n), 0.012);
  EXPECT_GT(std::sqrt(plain_squares / n), 0.1) << "the plain difference is of no use here";
}

TEST(VelocityEstimator, IsAtRestAtRest) {
  VelocityEstimator estimator(quantum_m, dt_s);
  for (int k = 0; k < 200; ++k) {
    const double flicker = k % 2 == 0 ? 0 : quantum_m;  // a position on the edge of two quanta
    const double v = estimator.next(Vec3(flicker, 0, 0)).x();
    if (k > 70) {
      EXPECT_LE(std::abs(v), quantum_m / (60 * dt_s)) << k;
    }
  }
}

TEST(VelocityEstimator, AnswersAStopWithinAFewTicks) {
  VelocityEstimator estimator(quantum_m, dt_s);
  const double speed = 0.5;
  int stopped = -1;
  for (int k = 0; k < 400; ++k) {
    const double v = estimator.next(Vec3(rounded(speed * std::min(k, 200) * dt_s), 0, 0)).x();
    if (k > 200 && stopped < 0 && std::abs(v) < 0.1) stopped = k - 200;
  }
  EXPECT_GT(stopped, 0);
  EXPECT_LE(stopped, 10);
}

}  // namespace
}  // namespace fingerpad::velocity_estimator_test
