#pragma once

#include "device/free_flight.hpp"
#include "device/surroundings.hpp"
#include "device/tried_steps.hpp"
#include "touch/tick_record.hpp"

namespace fingerpad {

/// How a finger goes up from what it has pressed, until it is free. noexcept, allocates nothing.
class PointerLift {
 public:
  /// @param around, flight, steps  kept by reference
  PointerLift(Surroundings& around, FreeFlight& flight, TriedSteps& steps) noexcept
      : around_(around), flight_(flight), steps_(steps) {}

  /// What each tick of the finger's has felt.
  void feel(const TickRecord& tick) noexcept {
    if (tick.walls > 0) out_W_ = tick.normal_W;
  }
  /// @param pressed_most_n  that the press might have pressed with
  void begin(const TickRecord& touched, double pressed_most_n) noexcept;
  /// Straight out, so far at most; once it is free, by half of the room that it has and a small step more.
  void go_on(const TickRecord& touched, double fastest_m, double dt_s) noexcept;
  bool is_over() const noexcept;
  /// What it may press with on its way [N].
  double most_n() const noexcept { return most_n_; }

 private:
  Surroundings& around_;
  FreeFlight& flight_;
  TriedSteps& steps_;
  Vec3 out_W_ = Vec3::UnitZ();  ///< the way out of what was touched last, unit
  int ticks_ = 0;
  double most_n_ = 0;
};

}  // namespace fingerpad
