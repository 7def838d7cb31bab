#include "motion/recording.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <cmath>
#include <numbers>

#include "motion/finger_path.hpp"
#include "motion/low_pass.hpp"
#include "support/refusal.hpp"

namespace fingerpad::recording_test {
namespace {

using testing::HasSubstr;

constexpr double pi = std::numbers::pi;

/// n samples at a rate, along x as `x_m` says.
template <typename Way>
Motion recorded(long n, double rate_hz, const Way& x_m) {
  Motion motion;
  motion.p_WQ = Points::Zero(3, n);
  for (long i = 0; i < n; ++i) {
    motion.t_s.push_back(static_cast<double>(i) / rate_hz);
    motion.p_WQ(0, i) = x_m(motion.t_s.back());
  }
  return motion;
}

std::vector<double> rounded_times(long n, double rate_hz, double quantum_s) {
  std::vector<double> t_s;
  for (long i = 0; i < n; ++i)
    t_s.push_back(std::round(static_cast<double>(i) / rate_hz / quantum_s) * quantum_s);
  return t_s;
}

TEST(RecordingClock, FindsTheRateThatIsThere) {
  for (const double rate_hz : {1000.0, 240.0, 59.94, 10.0, 4000.0}) {
    for (const double start_s : {0.0, 17.3, 1.7e9}) {
      std::vector<double> t_s;
      for (long i = 0; i < 500; ++i) t_s.push_back(start_s + static_cast<double>(i) / rate_hz);
      const RecordingClock clock = recording_clock(t_s);
      EXPECT_NEAR(clock.rate_hz, rate_hz, 1e-5 * rate_hz) << start_s;
      EXPECT_EQ(clock.odd_steps, 0);
      if (start_s > 1e9) continue;  // a double has no more than microseconds there
      EXPECT_EQ(clock.rate_hz, rate_hz) << start_s;
      EXPECT_TRUE(clock.is_even);
    }
  }
}

/// Whose steps, added up in any order, miss their sum by rounding.
TEST(RecordingClock, FindsTheRateOfALongRecordingToTheLastBit) {
  for (const long n : {286'202L, 1'000'001L}) {
    std::vector<double> t_s;
    for (long i = 0; i < n; ++i) t_s.push_back(static_cast<double>(i) * 0.0005);
    const RecordingClock clock = recording_clock(t_s);
    EXPECT_EQ(clock.rate_hz, 2000) << n;
    EXPECT_TRUE(clock.is_even) << n;
  }
}

TEST(RecordingClock, SeesThroughTheRoundingOfTimes) {
  // At 0.1 ms the steps of 240 Hz are 4.1 and 4.2 ms, and their median alone would say 238.1 Hz.
  const RecordingClock clock = recording_clock(rounded_times(1200, 240, 1e-4));
  EXPECT_EQ(clock.rate_hz, 240);
  EXPECT_FALSE(clock.is_even);
  EXPECT_EQ(clock.odd_steps, 0);
  EXPECT_EQ(clock_text(clock), "240 Hz (median of 1199 steps, from 4.1 to 4.2 ms)");
}

TEST(RecordingClock, CountsWhatIsMissing) {
  std::vector<double> t_s = rounded_times(600, 100, 1e-3);
  t_s.erase(t_s.begin() + 200, t_s.begin() + 205);
  t_s.erase(t_s.begin() + 300);
  const RecordingClock clock = recording_clock(t_s);
  EXPECT_EQ(clock.rate_hz, 100);
  EXPECT_EQ(clock.odd_steps, 2);
  EXPECT_NEAR(clock.longest_s, 0.06, 1e-12);
  EXPECT_NEAR(clock.longest_at_s, 1.99, 1e-12);
  EXPECT_EQ(recording_clock(std::vector<double>{3.0}).rate_hz, 0);
  EXPECT_EQ(recording_clock(std::vector<double>{0.0, 0.5, 100.0}).rate_hz, 2) << "of two the shorter";
}

/// Of a second-order Butterworth filter run twice, its frequencies bent by the bilinear transform.
double gain_of(double frequency_hz, double cutoff_hz, double rate_hz) {
  return 1 / (1 + std::pow(std::tan(pi * frequency_hz / rate_hz) / std::tan(pi * cutoff_hz / rate_hz), 4));
}

TEST(ZeroPhaseLowPass, HalvesASineAtItsCutoffAndDelaysNone) {
  const double rate_hz = 1000;
  for (const double cutoff_hz : {5.0, 20.0, 200.0}) {
    EXPECT_EQ(gain_of(cutoff_hz, cutoff_hz, rate_hz), 0.5);
    for (const double frequency_hz : {cutoff_hz, cutoff_hz / 10, 1.5 * cutoff_hz}) {
      const double gain = gain_of(frequency_hz, cutoff_hz, rate_hz);
      const double w = 2 * pi * frequency_hz / rate_hz;
      Eigen::VectorXd sine(6000);
      for (long i = 0; i < sine.size(); ++i) sine[i] = std::sin(w * static_cast<double>(i));
      const Eigen::VectorXd passed = ZeroPhaseLowPass(cutoff_hz, rate_hz).filtered(sine);
      // Away from the ends, where a sine does not go on as its reflection.
      for (long i = 2000; i < 4000; ++i)
        ASSERT_NEAR(passed[i], gain * sine[i], 1e-10) << cutoff_hz << " " << frequency_hz << " " << i;
    }
  }
}

TEST(ZeroPhaseLowPass, LeavesARampAsItIsToItsEnds) {
  for (const long n : {3, 10, 1000}) {
    const Eigen::VectorXd ramp = Eigen::VectorXd::LinSpaced(n, -3, 0.2);
    const Eigen::VectorXd passed = ZeroPhaseLowPass(10, 240).filtered(ramp);
    EXPECT_LT((passed - ramp).cwiseAbs().maxCoeff(), 1e-14) << n;
  }
}

TEST(ZeroPhaseLowPass, IsTheSameForthAndBack) {
  Eigen::VectorXd signal(300);
  for (long i = 0; i < signal.size(); ++i) signal[i] = std::sin(0.37 * static_cast<double>(i * i % 101));
  const ZeroPhaseLowPass low_pass(20, 240);
  const Eigen::VectorXd backwards = low_pass.filtered(signal.reverse());
  // What is left of the start after the reflection is 2e-10 of it.
  EXPECT_LT((backwards.reverse() - low_pass.filtered(signal)).cwiseAbs().maxCoeff(), 1e-8);
}

TEST(Recording, IsSmoothedAsAWhole) {
  const double rate_hz = 200, cutoff_hz = 10;
  Motion motion = recorded(2001, rate_hz, [](double t) { return 0.01 * std::sin(2 * pi * 10 * t); });
  motion.direction_W = Points::Zero(3, 2001);
  for (long i = 0; i < 2001; ++i) {
    const double wiggle = 0.01 * std::sin(2 * pi * 10 * motion.t_s[static_cast<std::size_t>(i)]);
    motion.normal_force_n.push_back(1 + wiggle);
    motion.direction_W.col(i) = Vec3(wiggle, 0, -1).normalized();
    motion.attitude.emplace_back(Eigen::AngleAxisd(2 * wiggle, Vec3::UnitZ()));
    if (i % 2 == 1) motion.attitude.back().coeffs() *= -1;  // the same attitude
  }
  const Motion before = motion;
  const Smoothing smoothing = smooth(motion, cutoff_hz, rate_hz);
  EXPECT_NEAR(smoothing.most_m, 0.005, 1e-5);
  EXPECT_NEAR(smoothing.rms_m, 0.005 / std::numbers::sqrt2, 1e-5);
  for (long i = 800; i < 1200; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double half = 0.5 * before.p_WQ(0, i);
    EXPECT_NEAR(motion.p_WQ(0, i), half, 1e-7);
    EXPECT_NEAR(motion.normal_force_n[at], 1 + half, 1e-7);
    // To the third order of a hundredth of a radian.
    EXPECT_NEAR(motion.direction_W(0, i), half, 2e-6);
    EXPECT_NEAR(std::abs(motion.attitude[at].angularDistance(Attitude::Identity())), std::abs(2 * half),
                4e-6);
    EXPECT_NEAR(motion.direction_W.col(i).norm(), 1, 1e-15);
  }
}

TEST(Recording, IsTakenAtEvenSteps) {
  Motion motion = recorded(1000, 240, [](double t) { return t; });
  motion.t_s = rounded_times(1000, 240, 1e-4);
  for (long i = 0; i < 1000; ++i) {
    motion.p_WQ(0, i) = 3 * motion.t_s[static_cast<std::size_t>(i)];
    motion.normal_force_n.push_back(motion.p_WQ(0, i));
  }
  const RecordingClock clock = recording_clock(motion.t_s);
  const Motion even = evenly_sampled(motion, clock);
  EXPECT_TRUE(recording_clock(even.t_s).is_even);
  EXPECT_GE(even.t_s.size(), 999u);
  ASSERT_EQ(even.normal_force_n.size(), even.t_s.size());
  for (std::size_t i = 0; i < even.t_s.size(); ++i) {
    EXPECT_NEAR(even.p_WQ(0, static_cast<Eigen::Index>(i)), 3 * even.t_s[i], 1e-14);
    EXPECT_NEAR(even.normal_force_n[i], 3 * even.t_s[i], 1e-14);
  }
  EXPECT_EQ(even.direction_W.cols(), 0);
  EXPECT_TRUE(even.attitude.empty());
  Motion gap = recorded(20, 100, [](double t) { return t; });
  gap.t_s.back() = 1000;
  EXPECT_THAT(test::why_not([&] { evenly_sampled(gap, recording_clock(gap.t_s)); }),
              HasSubstr("too uneven to be resampled: 20 samples, but 100000 steps"));
}

TEST(Recording, KeepsTheLastSampleThatRoundingHasPutBeforeItsTick) {
  Motion motion = recorded(480, 240, [](double t) { return t; });
  motion.t_s = rounded_times(480, 240, 1e-4);
  ASSERT_LT(motion.t_s.back(), 479 / 240.0);
  EXPECT_EQ(FingerPath(motion, 240, Vec3::UnitX()).tick_count(), 479);
  keep_last_sample(motion, recording_clock(motion.t_s));
  EXPECT_EQ(FingerPath(motion, 240, Vec3::UnitX()).tick_count(), 480);
  motion.t_s.back() -= 2e-3;  // no rounding
  keep_last_sample(motion, recording_clock(motion.t_s));
  EXPECT_EQ(FingerPath(motion, 240, Vec3::UnitX()).tick_count(), 479);
}

TEST(Recording, VelocityOfRoundedPositionsIsTheWindows) {
  // 20 mm/s at 240 Hz and 0.5 mm: a step of 83 um, so that plain differences are 0 or 120 mm/s.
  const double quantum_m = 5e-4, speed_m_per_s = 0.02;
  Motion motion =
      recorded(480, 240, [&](double t) { return std::round(speed_m_per_s * t / quantum_m) * quantum_m; });
  Motion plain = motion;
  estimate_velocity(motion, quantum_m, 240);
  estimate_velocity(plain, 0, 240);
  double worst = 0, plain_worst = 0;
  for (long i = 70; i < 480; ++i) {
    worst = std::max(worst, std::abs(motion.velocity_W(0, i) - speed_m_per_s));
    plain_worst = std::max(plain_worst, std::abs(plain.velocity_W(0, i) - speed_m_per_s));
  }
  // The longest window of 64 samples resolves quantum / 0.27 s.
  EXPECT_LT(worst, 1.01 * quantum_m / (64 / 240.0));
  EXPECT_GT(plain_worst, 0.09);

  // Between samples a finger's velocity is on the way from one to the next.
  const FingerPath path(motion, 480, Vec3::UnitX());
  const double mean = (motion.velocity_W(0, 200) + motion.velocity_W(0, 201)) / 2;
  EXPECT_NEAR(path.at(401).velocity_W.value().x(), mean, 1e-12);
  EXPECT_FALSE(FingerPath(recorded(2, 10, [](double t) { return t; }), 10, Vec3::UnitX()).at(0).velocity_W);
}

}  // namespace
}  // namespace fingerpad::recording_test
