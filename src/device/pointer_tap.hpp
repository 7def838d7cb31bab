#pragma once

#include <algorithm>

#include "device/pointer_aim.hpp"
#include "device/pointer_limits.hpp"

namespace fingerpad {

/// Makes a click a touch. The finger takes some time to come down, and a button that is pressed and let go
/// within it would do nothing: what such a press asked for is asked for on, where the pointer let go, until
/// the finger presses or it is clear that it does not get there.
class PointerTap {
 public:
  /// What the finger is to do in this tick. @param felt_n  normal force of the last tick
  const PointerAim& lead(const PointerAim& aim, double felt_n, double dt_s) noexcept {
    const double push_n = aim.finger.push_W_n.norm();
    if (push_n > 0) {
      if (!is_pressed_) begin();
      press_ = aim;
    }
    is_pressed_ = push_n > 0;
    asked_s_ += dt_s;
    most_n_ = std::max(most_n_, felt_n);
    if (is_pressed_ || has_ended()) return aim;
    return press_;
  }

 private:
  void begin() noexcept { asked_s_ = most_n_ = 0; }
  bool has_ended() const noexcept {
    return asked_s_ > pointer_limits::tap_s ||
           most_n_ >= pointer_limits::tap_share * press_.finger.push_W_n.norm();
  }

  PointerAim press_;  // the last that pressed; none asks for nothing
  bool is_pressed_ = false;
  double asked_s_ = 0;  // since the press began
  double most_n_ = 0;   // felt since then
};

}  // namespace fingerpad
