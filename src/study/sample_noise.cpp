#include "study/sample_noise.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace fingerpad {
namespace {

std::ptrdiff_t place_of_share(double share, std::size_t count) {
  return static_cast<std::ptrdiff_t>(share * static_cast<double>(count - 1));
}

}  // namespace

double quantile(std::span<const double> samples, double share) {
  std::vector<double> sorted(samples.begin(), samples.end());
  const std::ptrdiff_t at = place_of_share(share, sorted.size());
  std::nth_element(sorted.begin(), sorted.begin() + at, sorted.end());
  return sorted[static_cast<std::size_t>(at)];
}

double sample_noise(std::span<const double> samples) {
  std::vector<double> bends;
  bends.reserve(samples.size());
  for (std::size_t i = 2; i < samples.size(); ++i)
    bends.push_back(std::abs(samples[i] - 2 * samples[i - 1] + samples[i - 2]));
  return noise_of_bends(bends);
}

double noise_of_bends(std::span<const double> bends) {
  constexpr std::size_t fewest = 6;
  if (bends.size() < fewest) return 0;
  // The median is among what lies below the upper quartile.
  std::vector<double> sorted(bends.begin(), bends.end());
  const auto middle = sorted.begin() + place_of_share(0.5, sorted.size()),
             upper = sorted.begin() + place_of_share(0.75, sorted.size());
  std::nth_element(sorted.begin(), upper, sorted.end());
  std::nth_element(sorted.begin(), middle, upper);
  // A median of rounded numbers is itself rounded; it only says which bends are events.
  const double largest = 4 * std::max(*middle, 0.5 * *upper) / 0.6745;
  double squares = 0, count = 0;
  for (const double bend : bends) {
    if (bend > largest) continue;
    squares += bend * bend;
    ++count;
  }
  return count > 0 ? std::sqrt(squares / count / 6) : 0;
}

double median_of(std::span<const double> samples) {
  return samples.empty() ? 0 : quantile(samples, 0.5);
}

}  // namespace fingerpad
