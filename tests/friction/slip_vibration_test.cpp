#include "friction/slip_vibration.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace fingerpad::slip_vibration_test {
namespace {

/// Power of a signal at one frequency: Goertzel's recurrence over half-overlapping Hann windows of half a
/// second.
double power(const std::vector<double>& x, int rate_hz, double frequency_hz) {
  const std::size_t length = rate_hz / 2;
  std::vector<double> window(length);
  for (std::size_t k = 0; k < length; ++k) {
    window[k] = 1 - std::cos(2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(length));
  }
  const double turn = 2 * std::cos(2 * std::numbers::pi * frequency_hz / rate_hz);
  double sum = 0;
  for (std::size_t start = 0; start + length <= x.size(); start += length / 2) {
    double one = 0, two = 0;
    for (std::size_t k = 0; k < length; ++k) {
      const double next = window[k] * x[start + k] + turn * one - two;
      two = one;
      one = next;
    }
    sum += one * one + two * two - turn * one * two;
  }
  return sum;
}

/// Where the parabola through log power over 89 +- 12 Hz has its top. Single bins scatter; their fit does
/// not.
double peak_hz(const std::vector<double>& x, int rate_hz) {
  double moment[5] = {}, weighted[3] = {};  // sums of d^i, and of d^i times log power
  for (int bin = -6; bin <= 6; ++bin) {
    const double d = 2.0 * bin;
    const double log_power = std::log(power(x, rate_hz, 89 + d));
    for (int i = 0; i < 5; ++i) moment[i] += std::pow(d, i);
    for (int i = 0; i < 3; ++i) weighted[i] += std::pow(d, i) * log_power;
  }
  // Odd moments vanish: slope and curvature of the least-squares parabola stand apart.
  const double slope = weighted[1] / moment[2];
  const double curvature =
      (weighted[2] * moment[0] - weighted[0] * moment[2]) / (moment[4] * moment[0] - moment[2] * moment[2]);
  return 89 - slope / (2 * curvature);
}

class AtEveryRate : public testing::TestWithParam<int> {};

TEST_P(AtEveryRate, VarianceIsOne) {
  const int rate = GetParam(), seconds = 200;
  double sum = 0, squares = 0;
  SlipVibration vibration(89, 20, 1.0 / rate, RandomStream(11));
  for (int k = 0; k < rate * seconds; ++k) {
    const double x = vibration.next();
    sum += x;
    squares += x * x;
  }
  const double count = static_cast<double>(rate) * seconds;
  // Power is correlated over 1/(pi 20) s: about 2 pi 20 * 400 / 2 independent values; 4 standard errors are 5
  // %.
  EXPECT_NEAR(squares / count, 1, 0.06);
  EXPECT_NEAR(sum / count, 0, 0.02);
}

TEST_P(AtEveryRate, SpectrumPeaksAt89Hz) {
  const int rate = GetParam(), seconds = 200;
  SlipVibration vibration(89, 20, 1.0 / rate, RandomStream(7));
  std::vector<double> x(static_cast<std::size_t>(rate) * seconds);
  for (double& value : x) value = vibration.next();
  // 400 independent windows leave 5 % of scatter a bin, 0.15 Hz in the fit. SCIENCE 1 asks 88-90 Hz.
  EXPECT_NEAR(peak_hz(x, rate), 89, 1);
}

TEST_P(AtEveryRate, ABroadSpectrumPeaksAtItsFrequencyToo) {
  // At 60 Hz the poles' own angle lies 4 Hz above the peak; the fit, over 24 Hz of a top 60 Hz broad,
  // scatters by 1.5 Hz.
  const int rate = GetParam(), seconds = 200;
  SlipVibration vibration(89, 60, 1.0 / rate, RandomStream(7));
  std::vector<double> x(static_cast<std::size_t>(rate) * seconds);
  for (double& value : x) value = vibration.next();
  EXPECT_NEAR(peak_hz(x, rate), 89, 2);
}

TEST_P(AtEveryRate, StartsStationary) {
  const int rate = GetParam(), starts = 4000;
  SlipVibration vibration(89, 20, 1.0 / rate, RandomStream(13));
  std::vector<double> squares(6, 0);
  for (int i = 0; i < starts; ++i) {
    for (double& square : squares) square += std::pow(vibration.next(), 2);
    vibration.rest();
  }
  // A mean of 4000 squares of a normal number scatters by sqrt(2/4000) = 0.022; 4 of that.
  for (const double square : squares) EXPECT_NEAR(square / starts, 1, 0.09);
}

INSTANTIATE_TEST_SUITE_P(SlipVibration, AtEveryRate, testing::Values(500, 1000, 4000, 20000));

TEST(SlipVibration, IsTheSameForTheSameSeed) {
  SlipVibration a(89, 20, 1e-3, RandomStream(3)), b(89, 20, 1e-3, RandomStream(3)),
      c(89, 20, 1e-3, RandomStream(4));
  bool differs = false;
  for (int k = 0; k < 100; ++k) {
    const double x = a.next();
    EXPECT_EQ(x, b.next());
    differs = differs || x != c.next();
  }
  EXPECT_TRUE(differs);
}

TEST(SlipVibration, DrawsNothingAtRest) {
  SlipVibration a(89, 20, 1e-3, RandomStream(3)), b(89, 20, 1e-3, RandomStream(3));
  for (int k = 0; k < 50; ++k) b.rest();
  EXPECT_EQ(a.next(), b.next());
}

TEST(SlipVibration, NeverReversesFriction) {
  EXPECT_EQ(vibration_force_scale(0.05, 2), 1.1);
  EXPECT_EQ(vibration_force_scale(0.5, -3), 0);
}

}  // namespace
}  // namespace fingerpad::slip_vibration_test
