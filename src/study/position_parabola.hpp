#pragma once

#include <optional>

#include "study/measurement.hpp"

namespace fingerpad {

/// A parabola through positions along a direction, over the samples from one of them on [m].
struct PositionParabola {
  double place_m = 0, slope_m = 0, bend_m = 0;
  double at(double samples) const noexcept { return place_m + samples * (slope_m + samples * bend_m); }
  double slope_at(double samples) const noexcept { return slope_m + 2 * samples * bend_m; }
};

/// The parabola of least squares through `half` samples either way; nothing where the trial has no such many
/// without a gap.
std::optional<PositionParabola> position_parabola(const MeasuredTrial& trial, std::size_t middle,
                                                  std::size_t half, const Vec2& along);

}  // namespace fingerpad
