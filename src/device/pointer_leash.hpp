#pragma once

#include <limits>

#include "device/open_place.hpp"
#include "device/pointer_limits.hpp"

namespace fingerpad {

/// Whether a finger that presses can go on over the surface to what its pointer asks for, or must lift and
/// fly there: it is to come nearer all the while, and not from too far away. noexcept, allocates nothing.
class PointerLeash {
 public:
  /// @param near_m  as near as this it is there
  /// @param most_m  from farther away than this it flies
  PointerLeash(double near_m, double most_m, const Vec3& start_W) noexcept
      : near_m_(near_m), most_m_(most_m), landed_for_W_(start_W) {}

  /// It begins to come down.
  void begin() noexcept {
    nearest_m_ = std::numeric_limits<double>::infinity();
    delay_s_ = 0;
  }
  /// That is aimed at this place.
  void land_for(const Vec3& place_W) noexcept { landed_for_W_ = place_W; }

  /// A tick of the press.
  /// @param held_W  where the finger is held
  bool holds(const OpenPlace& open, const Vec3& held_W, double dt_s) noexcept {
    const double away_m = open.gain_m(held_W);
    if (away_m < near_m_ || away_m < (1 - pointer_limits::leash_gain) * nearest_m_) {
      nearest_m_ = away_m;
      delay_s_ = 0;
    } else {
      delay_s_ += dt_s;
    }
    // Landed as near as could be, it stays until the pointer goes on.
    if ((open.place_W() - landed_for_W_).norm() < near_m_) return true;
    return !is_held_up() && away_m < near_m_ + most_m_;
  }
  /// It has come no nearer for a while.
  bool is_held_up() const noexcept { return delay_s_ >= pointer_limits::leash_s; }

 private:
  double near_m_, most_m_;
  Vec3 landed_for_W_;                   // what the last landing was aimed at ...
  double nearest_m_ = 0, delay_s_ = 0;  // ... how near the finger has come, and for how long no nearer
};

}  // namespace fingerpad
