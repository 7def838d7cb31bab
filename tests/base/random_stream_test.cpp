#include "base/random_stream.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace fingerpad::random_stream_test {
namespace {

TEST(RandomStream, RepeatsForTheSameSeedAndStream) {
  RandomStream a(42, 3), b(42, 3);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(a.bits(), b.bits());
}

TEST(RandomStream, DiffersBetweenSeedsAndStreams) {
  EXPECT_NE(RandomStream(42, 3).bits(), RandomStream(42, 4).bits());
  EXPECT_NE(RandomStream(42, 3).bits(), RandomStream(43, 3).bits());
}

TEST(RandomStream, NormalNumbersHaveMeanZeroAndVarianceOne) {
  RandomStream random(1);
  const int n = 200000;
  double sum = 0, squares = 0, fourth = 0;
  for (int i = 0; i < n; ++i) {
    const double x = random.normal();
    sum += x;
    squares += x * x;
    fourth += x * x * x * x;
  }
  // Five standard errors: 1/sqrt(n), sqrt(2/n), sqrt(96/n).
  EXPECT_NEAR(sum / n, 0, 5 / std::sqrt(n));
  EXPECT_NEAR(squares / n, 1, 5 * std::sqrt(2.0 / n));
  EXPECT_NEAR(fourth / n, 3, 5 * std::sqrt(96.0 / n));
}

TEST(RandomStream, UniformNumbersFillTheUnitInterval) {
  RandomStream random(5);
  double sum = 0, lowest = 1, highest = 0;
  const int n = 100000;
  for (int i = 0; i < n; ++i) {
    const double u = random.uniform();
    sum += u;
    lowest = std::min(lowest, u);
    highest = std::max(highest, u);
  }
  EXPECT_NEAR(sum / n, 0.5, 5 / std::sqrt(12.0 * n));
  EXPECT_GE(lowest, 0);
  EXPECT_LT(highest, 1);
  EXPECT_LT(lowest, 1e-3);
  EXPECT_GT(highest, 1 - 1e-3);
}

}  // namespace
}  // namespace fingerpad::random_stream_test
