#pragma once

#include <algorithm>
#include <cmath>

#include "device/pointer_limits.hpp"
#include "device/pointer_path.hpp"

namespace fingerpad {

/// How long a pointer has rested, and what of the finger's motion is left after that. A still pointer has a
/// still finger in the end, also among walls that keep a flight from its goal, and where it is pressed in so
/// deep that no place holds it.
class PointerRest {
 public:
  /// The pointer went from one aim to the next, or stays.
  void note(const PointerAim& last, const PointerAim& aim, double dt_s) noexcept {
    const bool rests = aim.finger.p_WQ == last.finger.p_WQ && aim.finger.push_W_n == last.finger.push_W_n;
    if (!rests) forget();
    rests_s_ = rests && aim.towards_eye_W == last.towards_eye_W ? rests_s_ + dt_s : 0;
  }
  /// The finger presses in this tick, and has gone so far in or out for its force.
  void press(double gone_m, double dt_s) noexcept {
    pressed_s_ += dt_s;
    if (pressing_left() == 0) gone_m_ += gone_m;
  }
  /// What is touched is another: a press begins anew.
  void forget() noexcept { pressed_s_ = gone_m_ = 0; }

  /// Of a pressed finger's motion, from 1 to 0.
  double pressing_left() const noexcept {
    return left(pressed_s_ - pointer_limits::following_s, pointer_limits::fading_s);
  }
  /// How far a pressed finger has gone for its force since none of its motion was left. Where walls come and
  /// go with every step, no place gives just the force that is asked for.
  double gone_m() const noexcept { return gone_m_; }
  /// Of a flight.
  double flying_left() const noexcept {
    return left(rests_s_ - pointer_limits::flying_s, pointer_limits::flying_fading_s);
  }

 private:
  static double left(double over_s, double fading_s) noexcept {
    const double left = std::exp(-std::max(0.0, over_s) / fading_s);
    return left < pointer_limits::nothing_left ? 0 : left;
  }

  double rests_s_ = 0;    // so long it has rested
  double pressed_s_ = 0;  // so long it has rested while the finger pressed
  double gone_m_ = 0;
};

}  // namespace fingerpad
