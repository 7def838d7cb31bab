#pragma once

#include <cstdint>

namespace fingerpad {

/// A seeded stream of random numbers: SplitMix64 (Steele, Lea & Flood 2014) to spread the seed, xoshiro256++
/// (Blackman & Vigna 2019) to draw. The same seed and stream number give the same numbers on every machine.
class RandomStream {
 public:
  /// Streams of one seed and different numbers are independent.
  explicit RandomStream(std::uint64_t seed, std::uint64_t stream = 0) noexcept;

  std::uint64_t bits() noexcept;
  /// Uniform in [0, 1).
  double uniform() noexcept;
  /// Standard normal: mean 0, variance 1 (Marsaglia's polar method).
  double normal() noexcept;

 private:
  std::uint64_t state_[4];
  double spare_ = 0;
  bool has_spare_ = false;
};

}  // namespace fingerpad
