#pragma once

#include "device/foresight.hpp"
#include "device/free_flight.hpp"
#include "touch/tick_record.hpp"

namespace fingerpad {

/// A finger's next step, which is tried before it is made. noexcept, allocates nothing.
class TriedSteps {
 public:
  /// @param foresight, flight  kept by reference; the flight's place is the finger's
  TriedSteps(Foresight& foresight, FreeFlight& flight) noexcept : foresight_(foresight), flight_(flight) {}

  /// Goes so far where that presses with no more than `most_n`.
  bool go(const Vec3& step_W, double most_n, double dt_s) noexcept;
  /// Goes so far, or half as far, and so on.
  bool go_shorter(Vec3 step_W, double most_n, double dt_s) noexcept;
  /// Straight out of what was touched, as little as is enough: none, or as far as it goes in a tick. Only
  /// where that presses with more than `most_n` it goes farther; all the way, if that presses with no more
  /// than `at_worst_n`. @pre farthest_m > 0
  void give_way(const TickRecord& touched, double most_n, double at_worst_n, double farthest_m,
                double dt_s) noexcept;

 private:
  Foresight& foresight_;
  FreeFlight& flight_;
};

}  // namespace fingerpad
