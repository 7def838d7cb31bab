#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>

namespace fingerpad {

/// How often times of different lengths occurred, in fixed buckets, four to a doubling: each bucket is 19 %
/// longer than the one before, from half a microsecond to beyond a second.
struct TimeCounts {
  static constexpr int buckets = 88;
  static constexpr double least_s = 0.5e-6;

  std::array<std::uint64_t, buckets> counts{};

  /// The bucket of a time; what is shorter than the first or longer than the last counts there.
  static int bucket_of(double seconds) noexcept {
    if (!(seconds > least_s)) return 0;
    return std::min(buckets - 1, 1 + static_cast<int>(4 * std::log2(seconds / least_s)));
  }
  /// The longest time of a bucket [s].
  static double upper_s(int bucket) noexcept { return least_s * std::exp2(bucket / 4.0); }

  std::uint64_t total() const noexcept {
    std::uint64_t sum = 0;
    for (const std::uint64_t count : counts) sum += count;
    return sum;
  }
  /// No longer than this were a share of the times, to within a bucket [s]; 0 where there are none.
  double quantile_s(double share) const noexcept {
    const double wanted = share * static_cast<double>(total());
    double sum = 0;
    for (int i = 0; i < buckets && wanted > 0; ++i) {
      sum += static_cast<double>(counts[static_cast<std::size_t>(i)]);
      if (sum >= wanted) return upper_s(i);
    }
    return 0;
  }
};

/// Counts times on one thread, for any other to read at any moment without holding it up.
class TimeHistogram {
 public:
  void note(double seconds) noexcept {
    auto& count = counts_[static_cast<std::size_t>(TimeCounts::bucket_of(seconds))];
    count.store(count.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
  }
  TimeCounts counts() const noexcept {
    TimeCounts now;
    for (std::size_t i = 0; i < counts_.size(); ++i)
      now.counts[i] = counts_[i].load(std::memory_order_relaxed);
    return now;
  }

 private:
  std::array<std::atomic<std::uint64_t>, TimeCounts::buckets> counts_{};
};

/// How a servo loop keeps its time.
struct ServoTiming {
  long ticks = 0;
  long late_ticks = 0;      ///< started more than one tick after their time
  double worst_late_s = 0;  ///< of all starts
  double worst_tick_s = 0;  ///< the longest tick, from its start to its end
  TimeCounts tick_times, latenesses;

  /// So long a tick took at most, of this share of all: a bucket's end, or the longest of all.
  double tick_s(double share) const noexcept { return std::min(tick_times.quantile_s(share), worst_tick_s); }
  double late_share() const noexcept {
    return ticks > 0 ? static_cast<double>(late_ticks) / static_cast<double>(ticks) : 0;
  }
};

}  // namespace fingerpad
