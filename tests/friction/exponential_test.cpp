#include "friction/exponential.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace fingerpad::exponential_test {
namespace {

// Against libm in long double, whose own error (5e-20 of the value) is far below a double's rounding
// of 1.1e-16.

TEST(ExpOfMinus, IsTheExponentialToAFewRoundings) {
  for (double x = 0; x < 690; x += 0.0371 + x * 1e-3) {
    const long double expected = std::exp(-static_cast<long double>(x));
    EXPECT_NEAR(exp_of_minus(x) / expected, 1, 3e-16) << x;
  }
  EXPECT_EQ(exp_of_minus(0), 1);
}

TEST(Yielding, IsExactFromTheTiniestStepToTheLongest) {
  for (double x = 1e-15; x < 1e6; x *= 1.7) {
    const long double expected = -std::expm1(-static_cast<long double>(x));
    const Yielding found = yielding(x);
    // Above 1e-3 the difference from 1 loses three digits.
    EXPECT_NEAR(found.share / expected, 1, 3e-13) << x;
    EXPECT_NEAR(found.per_x / (expected / x), 1, 3e-13) << x;
  }
  EXPECT_EQ(yielding(100).share, 1);
}

TEST(SineOfHalfTurns, IsTheSine) {
  for (double u = -0.5; u <= 0.5; u += 0.0013) {
    const long double expected = std::sin(std::numbers::pi_v<long double> * u);
    EXPECT_NEAR(sine_of_half_turns(u), static_cast<double>(expected), 4e-16) << u;  // a few roundings of 1
  }
  EXPECT_NEAR(sine_of_half_turns(0.5), 1, 4e-16);
}

TEST(InverseCubeRoot, IsExactOverAllLoads) {
  for (double x = 1e-250; x < 1e250; x *= 3.7) {
    const long double expected = 1 / std::cbrt(static_cast<long double>(x));
    EXPECT_NEAR(inverse_cube_root(x) / expected, 1, 6e-16) << x;  // the last step's few roundings
  }
  EXPECT_TRUE(std::isfinite(inverse_cube_root(0)));
}

}  // namespace
}  // namespace fingerpad::exponential_test
