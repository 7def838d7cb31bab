#include "study/sample_noise.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace fingerpad {
namespace {

std::ptrdiff_t place_of_share(double share, std::size_t count) {
  return static_cast<std::ptrdiff_t>(share * static_cast<double>(count - 1));
}

double nth_of(std::vector<double>& samples, std::ptrdiff_t at) {
  std::nth_element(samples.begin(), samples.begin() + at, samples.end());
  return samples[static_cast<std::size_t>(at)];
}

/// What nth_of gives, of many samples sooner: every 32nd tells between which values it surely is, nearly
/// always, and only those are put in order.
double order_statistic(std::span<const double> samples, std::ptrdiff_t at) {
  constexpr std::size_t few = 1024, stride = 32;
  constexpr double deviations = 4;
  std::vector<double> near;
  if (samples.size() >= few) {
    for (std::size_t i = 0; i < samples.size(); i += stride) near.push_back(samples[i]);
    std::sort(near.begin(), near.end());
    const double share = static_cast<double>(at) / static_cast<double>(samples.size()),
                 last = static_cast<double>(near.size() - 1),
                 reach = deviations * std::sqrt(share * (1 - share) * last) + 1;
    const double low = near[static_cast<std::size_t>(std::max(0.0, share * last - reach))],
                 high = near[static_cast<std::size_t>(std::min(last, share * last + reach))];
    near.resize(samples.size());
    std::size_t below = 0, within = 0;
    for (const double sample : samples) {
      below += sample < low ? 1 : 0;
      near[within] = sample;
      within += sample >= low && sample <= high ? 1 : 0;
    }
    const auto first = static_cast<std::ptrdiff_t>(below);
    if (first <= at && at < first + static_cast<std::ptrdiff_t>(within)) {
      near.resize(within);
      return nth_of(near, at - first);
    }
  }
  near.assign(samples.begin(), samples.end());
  return nth_of(near, at);
}

}  // namespace

double quantile(std::span<const double> samples, double share) {
  return order_statistic(samples, place_of_share(share, samples.size()));
}

double sample_noise(std::span<const double> samples) {
  std::vector<double> bends;
  bends.reserve(samples.size());
  for (std::size_t i = 2; i < samples.size(); ++i)
    bends.push_back(std::abs(samples[i] - 2 * samples[i - 1] + samples[i - 2]));
  return noise_of_bends(bends);
}

double joined_noise(std::span<const double> samples) {
  std::vector<double> every_other;
  every_other.reserve(samples.size() / 2 + 1);
  for (std::size_t i = 0; i < samples.size(); i += 2) every_other.push_back(samples[i]);
  const double noise = sample_noise(samples);
  return noise > 0 ? sample_noise(every_other) / noise : 1;
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
