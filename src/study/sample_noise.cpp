#include "study/sample_noise.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace fingerpad {

double quantile(std::span<const double> samples, double share) {
  std::vector<double> sorted(samples.begin(), samples.end());
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(sorted.size() - 1));
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
  // A median of rounded numbers is itself rounded; it only says which bends are events.
  const double largest = 4 * std::max(quantile(bends, 0.5), 0.5 * quantile(bends, 0.75)) / 0.6745;
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
