#include "study/sample_noise.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/random_stream.hpp"

namespace fingerpad::sample_noise_test {
namespace {

double by_sorting(std::vector<double> samples, double share) {
  std::sort(samples.begin(), samples.end());
  return samples[static_cast<std::size_t>(share * static_cast<double>(samples.size() - 1))];
}

/// Of many samples, too: those that every 32nd speaks for, those that it does not, and those that are alike.
TEST(SampleNoise, AQuantileIsThatOfTheSortedSamples) {
  RandomStream random(1);
  for (const std::size_t count : {1U, 7U, 1023U, 1024U, 5000U}) {
    std::vector<double> noise(count), rounded(count), odd(count), rising(count);
    for (std::size_t i = 0; i < count; ++i) {
      noise[i] = random.normal();
      rounded[i] = std::round(noise[i]);
      odd[i] = i % 32 == 0 ? 100 : noise[i];
      rising[i] = static_cast<double>(i);
    }
    for (const double share : {0.0, 0.01, 0.5, 0.667, 0.75, 0.98, 1.0})
      for (const auto& samples : {noise, rounded, odd, rising})
        EXPECT_EQ(quantile(samples, share), by_sorting(samples, share)) << count << " " << share;
  }
}

}  // namespace
}  // namespace fingerpad::sample_noise_test
