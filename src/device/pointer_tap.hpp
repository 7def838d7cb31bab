#pragma once

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
    const bool begins = aim.presses() && !is_pressed_;
    if (begins) *this = PointerTap();
    if (aim.presses()) press_ = aim;
    is_pressed_ = aim.presses();
    asked_s_ += dt_s;
    if (is_pressed_) held_s_ += dt_s;
    const bool is_firm = felt_n >= pointer_limits::tap_share * press_.finger.push_W_n.norm();
    is_felt_ |= is_firm && was_light_;
    was_light_ |= !is_firm;
    return is_pressed_ || has_ended() ? aim : press_;
  }

  /// Asks for nothing on, also when what is pressed now is let go.
  void let_go() noexcept { is_felt_ = true; }

 private:
  bool has_ended() const noexcept {
    return !press_.presses() || is_felt_ || held_s_ > pointer_limits::tap_s ||
           asked_s_ > pointer_limits::tap_waits_s;
  }

  PointerAim press_;  // the last that pressed; none asks for nothing
  bool is_pressed_ = false;
  double asked_s_ = 0;      // since the press began
  double held_s_ = 0;       // of that the button was down
  bool was_light_ = false;  // what is felt since then is no longer that of a press before
  bool is_felt_ = false;
};

}  // namespace fingerpad
