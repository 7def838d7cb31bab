#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "motion/velocity_estimator.hpp"
#include "study/bench_scene.hpp"

namespace fingerpad::velocity_quantum_test {
namespace {

constexpr double quantum_m = 3e-5, v_min_m_per_s = 0.1;

/// The fastest that a finger of constant speed seems to be, through encoders, once it has moved for 0.1 s.
double fastest_seen(double speed_m_per_s, double rate_hz, bool knows_quantum) {
  VelocityEstimator estimator(knows_quantum ? quantum_m : 0, 1 / rate_hz);
  double fastest = 0;
  for (int k = 0; k < rate_hz; ++k) {
    const double x_m = std::round(speed_m_per_s * k / rate_hz / quantum_m) * quantum_m;
    const double seen = estimator.next(Vec3(x_m, 0, 0)).x();
    if (k > rate_hz / 10) fastest = std::max(fastest, seen);
  }
  return fastest;
}

TEST(VelocityQuantum, APlainDifferenceSeesAQuantumATick) {
  // SCIENCE 4: 0.03 m/s at 1 kHz, 0.3 m/s at 10 kHz, above v_min. Positions of 0.02 m round at 4e-18 m.
  EXPECT_NEAR(fastest_seen(0.02, 1000, false), 0.03, 1e-9);
  EXPECT_NEAR(fastest_seen(0.02, 10000, false), 0.3, 1e-9);
}

TEST(VelocityQuantum, AnEstimatorThatKnowsItStaysBelowVMin) {
  for (const double rate_hz : {1000.0, 10000.0}) {
    EXPECT_LT(fastest_seen(0.02, rate_hz, true), v_min_m_per_s / 2) << rate_hz;
  }
}

/// Share of ticks in slip while the finger, seen through encoders, is drawn at a constant speed at 10 kHz.
double slip_share(double speed_m_per_s) {
  BenchScene bench(10000, "stick-slip");
  HandSettings& hand = bench.hold({.encoder_m = quantum_m});
  for (bool& free : hand.free_axis) free = false;  // it follows the motion; its encoders round
  ClosedLoop loop = bench.loop(1, [&](double t_s) { return Vec3(speed_m_per_s * t_s, 0, -0.001); });
  long slip = 0, counted = 0;
  for (long k = 0; k < loop.tick_count(); ++k) {
    const TickRecord record = loop.next();
    if (k < 1000) continue;
    ++counted;
    slip += record.phase == Phase::slip ? 1 : 0;
  }
  return static_cast<double>(slip) / static_cast<double>(counted);
}

TEST(VelocityQuantum, VMinWorksAtTenKilohertzThroughThreeHundredthsOfAMillimetre) {
  // Below v_min each tooth of 0.1 mm holds again at once; it is seen in steps of 0.03 mm.
  EXPECT_EQ(slip_share(0.02), 0);
  EXPECT_GT(slip_share(0.2), 0.99);
}

}  // namespace
}  // namespace fingerpad::velocity_quantum_test
