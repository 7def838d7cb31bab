#pragma once

#include <cmath>
#include <cstdint>

namespace fingerpad {

/// When a window system's events were made, on a steady clock. Its own milliseconds begin anywhere, and anew
/// after 49 days; an event that a program has made up may have none (0), or any.
class EventClock {
 public:
  /// @param now_s  when the event was taken, which counts where its own time makes no sense
  double time_s(unsigned long server_ms, double now_s) noexcept {
    if (server_ms == 0) return now_s;
    if (!has_first_ || said_s(server_ms) - now_s > most_off_s) {
      has_first_ = true;
      first_ms_ = server_ms;
      first_s_ = now_s;
    }
    const double event_s = said_s(server_ms);
    return std::abs(event_s - now_s) > most_off_s ? now_s : event_s;
  }

 private:
  /// No frame keeps events waiting for longer.
  static constexpr double most_off_s = 1;

  double said_s(unsigned long server_ms) const noexcept {
    return first_s_ + 1e-3 * static_cast<std::int32_t>(static_cast<std::uint32_t>(server_ms - first_ms_));
  }

  bool has_first_ = false;
  unsigned long first_ms_ = 0;
  double first_s_ = 0;
};

}  // namespace fingerpad
