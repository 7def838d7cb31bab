#pragma once

#include <vector>

#include "view/touch_window.hpp"

namespace fingerpad {

/// The ticks of the last seconds of a live touch, gathered from frame to frame.
class RecentTicks {
 public:
  explicit RecentTicks(double kept_s) : kept_s_(kept_s) {}

  /// Asks the touch for what is new since the last call, and forgets what is too old.
  void gather(const TouchWindowInput& input);

  /// Oldest first.
  const std::vector<TickRecord>& rows() const { return rows_; }

  /// Speed (shown_speed) over the last 20 ms: from tick to tick a quantised position makes noise.
  /// @returns nan without ticks
  double speed_m_per_s() const;

 private:
  double kept_s_;
  std::vector<TickRecord> rows_;
};

}  // namespace fingerpad
