#include "device/trip_watch.hpp"

#include <fmt/format.h>

#include "base/number_text.hpp"

namespace fingerpad {

TripWatch::Lately TripWatch::lately(std::int64_t now_ns) const noexcept {
  constexpr std::int64_t readable_ns = 1'000'000'000;
  const auto is_near = [&](std::int64_t at_ns) { return at_ns != never_ns && now_ns - at_ns < readable_ns; };
  if (is_near(before_ns_.load(std::memory_order_relaxed))) return Lately::again;
  return is_near(last_ns_.load(std::memory_order_relaxed)) ? Lately::once : Lately::none;
}

std::string trips_words(const TripWatch& trips, const char* what, std::uint64_t heard, double watchdog_s) {
  const std::uint64_t count = trips.count();
  if (count == 0) return {};
  // A pause now and then is none of the device's rate, nor is its end.
  const bool too_seldom = count > 2 && 20 * count > heard;
  return fmt::format(
      "; no {} for {} ms lifted the finger {}{}", what, rounded_text(1e3 * watchdog_s, 4),
      count == 1 ? "once" : fmt::format("{} times", count),
      too_seldom ? ": the device sends too seldom (or watchdog_s in [device] is too short)" : "");
}

}  // namespace fingerpad
