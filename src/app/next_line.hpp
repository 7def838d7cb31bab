#pragma once

#include <chrono>

namespace fingerpad {

/// When the next is due of the lines that tell now and then how far it is.
class NextLine {
 public:
  /// @param between  at least so long passes before the first, and from one to the next
  explicit NextLine(std::chrono::milliseconds between) : between_(between) {}

  /// Whether one is due, which is taken for written then.
  bool is_due() {
    const Clock::time_point now = Clock::now();
    if (now - last_ < between_) return false;
    last_ = now;
    return true;
  }

 private:
  using Clock = std::chrono::steady_clock;
  std::chrono::milliseconds between_;
  Clock::time_point last_ = Clock::now();
};

}  // namespace fingerpad
