#pragma once

#include <array>
#include <atomic>

#include "device/pointer_aim.hpp"

namespace fingerpad {

/// Plays a pointer's events back at the pace at which they were made. A window hands them over frame by
/// frame, several at once; their own times say how fast the pointer went. One thread puts, one plays;
/// neither waits for the other.
class PointerPath {
 public:
  explicit PointerPath(const PointerAim& start) noexcept : from_(start), shown_(start) {}

  /// What the pointer did next. Lost where a thousand events wait already, since nobody plays them; but not
  /// the end of a press that is kept: the last places are for it.
  void put(const PointerAim& aim) noexcept;

  /// Where the pointer was, dt_s after the last call. It runs as late as the events come, goes on evenly from
  /// one to the next, and rests where there is none.
  const PointerAim& advance(double dt_s) noexcept;

 private:
  static constexpr std::size_t capacity = 1024;

  const PointerAim* next() const noexcept;
  void show(const PointerAim& to) noexcept;

  std::array<PointerAim, capacity> ring_;
  std::atomic<std::size_t> put_{0}, taken_{0};  // counts; the ring's places are their remainders
  bool pressed_ = false;                        // the last that was put; the putter's own

  // The player's own.
  PointerAim from_, shown_;
  double now_s_ = 0;
  bool started_ = false, rested_ = true;
};

}  // namespace fingerpad
