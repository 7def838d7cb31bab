#pragma once

#include <algorithm>

namespace fingerpad {

/// 0 up to `from`, 1 from `to` on, smoothly between; either may be the larger.
inline double smoothstep(double from, double to, double x) noexcept {
  const double s = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return s * s * (3 - 2 * s);
}

}  // namespace fingerpad
