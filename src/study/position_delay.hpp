#pragma once

#include <array>
#include <vector>

#include "study/stick_segments.hpp"

namespace fingerpad {

/// The lags that are tried: 50 ms either way. They lie as near at every rate: over steps of a slow clock's
/// samples, which stick is hardly longer than, what a lag explains is no parabola.
inline constexpr double delay_step_s = 1e-3;
inline constexpr int delay_lags_each_way = 50;
inline constexpr std::size_t delay_lags = 2 * std::size_t{delay_lags_each_way} + 1;

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

  DelaySums& operator+=(const DelaySums& other);
};

DelaySums delay_sums(const MeasuredTrial& trial, const StickSegments& segments);
/// The same in up to a dozen parts, of stretches that follow one another: what a few trials say of how far it
/// may be off.
std::vector<DelaySums> delay_sums_by_part(const MeasuredTrial& trial, const StickSegments& segments);

/// Moves a trial's positions by a delay, so that they are those of the forces' moments: whole samples, and
/// the rest along the velocity, which adds no noise.
void shift_positions(RecordedTrial& trial, double delay_s);

}  // namespace fingerpad
