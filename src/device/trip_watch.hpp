#pragma once

#include <atomic>
#include <cstdint>
#include <string>

namespace fingerpad {

/// How often a watchdog has lifted the finger, and how lately, so that what lasts milliseconds can be read.
class TripWatch {
 public:
  /// Of a time shortly ago: none, one trip, or one after the other.
  enum class Lately { none, once, again };

  /// One more, at a time of the program's clock. Servo's thread; allocates nothing.
  void trip(std::int64_t now_ns) noexcept {
    before_ns_.store(last_ns_.load(std::memory_order_relaxed), std::memory_order_relaxed);
    last_ns_.store(now_ns, std::memory_order_relaxed);
    count_.fetch_add(1, std::memory_order_relaxed);
  }

  /// Any thread.
  std::uint64_t count() const noexcept { return count_.load(std::memory_order_relaxed); }
  Lately lately(std::int64_t now_ns) const noexcept;

 private:
  static constexpr std::int64_t never_ns = -1;
  std::atomic<std::uint64_t> count_{0};
  std::atomic<std::int64_t> last_ns_{never_ns}, before_ns_{never_ns};
};

/// "; no packet for 20 ms lifted the finger 36 times: the device sends too seldom"; empty without a trip.
/// @param what   that comes from the device: "packet"
/// @param heard  how many came
std::string trips_words(const TripWatch& trips, const char* what, std::uint64_t heard, double watchdog_s);

}  // namespace fingerpad
