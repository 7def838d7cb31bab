#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "touch/tick_record.hpp"

namespace fingerpad {

/// Where a run's contact went, in few points; the finger where it touched nothing.
struct SmallPath {
  std::vector<Vec3> points_W;
  // One a point, of the way that leads to it:
  std::vector<double> force_n;  ///< the greatest force on the finger
  std::vector<Phase> phases;    ///< where that force acted
};

/// Points by the way gone and by time alike, so that neither a fast stretch nor a long rest is lost.
/// @param most  points, >= 2
SmallPath small_path(const std::vector<TickRecord>& rows, std::size_t most);

/// What a strip chart shows over time.
struct StripCurve {
  std::string_view name, unit;
  std::vector<double> values;  ///< nan where there is none
  /// Of buckets: where in its own each value was, in 255ths of its length.
  std::vector<std::uint8_t> places = {};
};

/// A run's curves in few samples: of each bucket of ticks a curve's least and greatest value, in their order,
/// so that no peak is lost.
struct SmallSeries {
  double begin_s = 0, step_s = 0;  ///< of the shares: one each bucket, or each tick
  double bucket_s = 0;             ///< of two samples; 0: each tick is one
  std::vector<StripCurve> curves;
  /// Of a bucket's ticks those that slip and those that stick, in 255ths; some are at least 1. The rest is
  /// free.
  std::vector<std::uint8_t> slip_share, stick_share;
  std::vector<std::uint8_t> ruptures;  ///< how often stick gave way there; 255: or oftener
};

/// @param most  samples, >= 2; fewer ticks are kept as they are
SmallSeries small_series(const std::vector<TickRecord>& rows, std::size_t most);

}  // namespace fingerpad
