#pragma once

#include <algorithm>
#include <limits>

#include "base/types.hpp"
#include "device/pointer_limits.hpp"

namespace fingerpad {

/// Whether a hand that presses can be drawn on over the surface to what its pointer asks for, or must lift
/// and fly there: round an edge its spring would hold it against the side for ever. noexcept, allocates
/// nothing.
class HandLeash {
 public:
  /// @param near_m  as near as this it is there
  explicit HandLeash(double near_m) noexcept : near_m_(near_m) {}

  /// It comes down to be pressed at this place.
  void begin(const Vec3& place_W) noexcept {
    landed_for_W_ = last_place_W_ = place_W;
    nearest_m_ = std::numeric_limits<double>::infinity();
    delay_s_ = 0;
  }

  /// A tick of the press.
  /// @param off_m  how far the hand is from the place
  bool holds(const Vec3& place_W, double off_m, double dt_s) noexcept {
    delay_s_ += dt_s;
    // As far as the place goes away, it need not have come nearer.
    nearest_m_ += (place_W - last_place_W_).norm();
    last_place_W_ = place_W;
    if (off_m < near_m_ || off_m < (1 - pointer_limits::leash_gain) * nearest_m_) {
      nearest_m_ = off_m;
      delay_s_ = 0;
    }
    // Landed as near as could be, it stays until the pointer goes on.
    if (off_m < near_m_ || (place_W - landed_for_W_).norm() < near_m_) return true;
    return delay_s_ < pointer_limits::leash_s;
  }

 private:
  double near_m_;
  Vec3 landed_for_W_ = Vec3::Zero(), last_place_W_ = Vec3::Zero();
  double nearest_m_ = 0, delay_s_ = 0;  ///< how near it has come, and for how long no nearer
};

}  // namespace fingerpad
