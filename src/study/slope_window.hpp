#pragma once

#include <algorithm>
#include <cmath>

namespace fingerpad {

/// Half of the window over which the slopes of a trial's samples are told [s]: long enough that noise of
/// positions hardly moves them, and short against strokes of a finger.
inline constexpr double slope_half_window_s = 6e-3;

/// The same in samples, at least three: fewer tell no slope beside their noise.
inline int slope_half_window(double rate_hz) {
  constexpr int fewest = 3;
  return std::max(fewest, static_cast<int>(std::lround(slope_half_window_s * rate_hz)));
}

}  // namespace fingerpad
