#pragma once

#include "view/view_input.hpp"

namespace fingerpad {

/// Where a player stands in a touch: a time between its first row and its last.
class Playback {
 public:
  /// @param input  kept by reference; with at least one row
  explicit Playback(const ViewInput& input);

  double t_s() const noexcept { return t_s_; }
  long row() const noexcept { return row_; }
  bool playing() const noexcept { return playing_; }
  double speed() const noexcept { return speed_; }

  void go_to(double t_s);
  /// Rows on or back; stops playing.
  void step(long rows);
  /// Starts (from the beginning when at the end) or stops.
  void toggle();
  /// Times two, or half; from 1/1024 to 16.
  void change_speed(bool faster);
  /// The clock went on by this much. @returns whether the moment changed
  bool advance(double elapsed_s);

 private:
  const ViewInput& input_;
  double t_s_ = 0, speed_ = 1;
  long row_ = 0;
  bool playing_ = false;
};

}  // namespace fingerpad
