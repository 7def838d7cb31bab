#pragma once

#include <array>
#include <vector>

#include "study/stick_segments.hpp"

namespace fingerpad {

/// The lags that are tried: 50 ms either way. They lie as near at every rate: over steps of a slow clock's
/// samples, which stick is hardly longer than, what a lag explains is no parabola.
inline constexpr double delay_step_s = 1e-3;
inline constexpr int delay_lags_each_way = 50;

/// What a trial says about the delay of force behind position: how well, in stick, the force ratio follows
/// the position of a moment before, for each lag of the grid. Sums, so that those of several trials add up.
struct DelaySums {
  int subject = 0;
  double sample_s = 0;  ///< between the trial's samples
  /// Per axis and lag, about each stretch's means: products of the position with itself, and with q, q |q|^2
  /// and q |q|^4.
  std::array<std::vector<double>, 2> xx;
  std::array<std::vector<Vec3>, 2> xq;
  std::array<Mat3, 2> spring{Mat3::Zero(), Mat3::Zero()};  ///< products of these three with one another
  double noise_m2 = 0;                                     ///< what noise made of xx, taken off it
  long samples = 0;
};

DelaySums delay_sums(const MeasuredTrial& trial, const StickSegments& segments);

/// The lag of the highest cross-correlation: the one at which a spring, of first, third or fifth order and of
/// its own for each trial and axis, explains most (without the higher orders its bend would pass for a
/// delay), refined by the parabola through the highest three. Within 50 ms either way. A spring that yields
/// late (hysteresis) looks like a delay: what they share is taken for delay.
DelayEstimate estimate_delay(const std::vector<DelaySums>& trials, std::uint64_t seed);

/// Moves a trial's positions by a delay, so that they are those of the forces' moments: whole samples, and
/// the rest along the velocity, which adds no noise.
void shift_positions(RecordedTrial& trial, double delay_s);

}  // namespace fingerpad
