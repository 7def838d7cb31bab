#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "touch/tick_record.hpp"

namespace fingerpad {

/// Where a run's contact went, in few points; the finger where it touched nothing.
struct SmallPath {
  std::vector<Vec3> points_W;
  // For each point, of the ticks since the point before it:
  std::vector<double> force_n;  ///< the greatest force on the finger
  std::vector<Phase> phases;    ///< the phase of the tick with that force
};

/// Three quarters of the points are spread evenly over the length of the path, one quarter over time: a fast
/// stretch and a long rest both keep some.
/// @param most  points, >= 2
SmallPath small_path(const std::vector<TickRecord>& rows, std::size_t most);

/// One curve of a strip chart.
struct StripCurve {
  std::string_view name, unit;
  std::vector<double> values;  ///< nan where there is none
  /// When each value was taken, from the beginning of its bucket (0) to its end (255). Empty without buckets.
  std::vector<std::uint8_t> places = {};
};

/// A run's curves in few samples. A long run is divided into buckets, stretches of ticks; each curve keeps
/// two samples a bucket, its least and its greatest value in the order in which they came, so that no peak is
/// lost. A short run keeps every tick.
struct SmallSeries {
  double begin_s = 0;   ///< of the run
  double step_s = 0;    ///< from one entry of the shares to the next: a bucket, or a tick without buckets
  double bucket_s = 0;  ///< length of a bucket; 0: there are none
  std::vector<StripCurve> curves;
  /// The share of the ticks that slip, and that stick, in 255ths: one entry a bucket, or a tick. It is at
  /// least 1 where any tick does. The others are free.
  std::vector<std::uint8_t> slip_share, stick_share;
  std::vector<std::uint8_t> ruptures;  ///< how often stick gave way, 255 at most; entries as of the shares
};

/// @param most  samples, >= 2; fewer ticks are kept as they are
SmallSeries small_series(const std::vector<TickRecord>& rows, std::size_t most);

}  // namespace fingerpad
