#pragma once

#include <chrono>
#include <cstdint>

namespace fingerpad {

/// A clock that only goes forward [ns]. Tests give their own.
using DeviceClock = std::int64_t (*)();

inline std::int64_t steady_clock_ns() {
  using std::chrono::duration_cast;
  return duration_cast<std::chrono::nanoseconds>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace fingerpad
