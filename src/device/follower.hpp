#pragma once

#include <cmath>
#include <numbers>

#include "base/types.hpp"

namespace fingerpad {

/// Follows a mouse closely, yet smooths a screen's 60 positions a second.
inline constexpr double pointer_bandwidth_hz = 8;

/// A place that follows another the way a hand would: critically damped, so that the few positions a second
/// that a pointer gives become a smooth motion at the servo rate. Exact between ticks, whatever the rate:
/// x'' = w^2 (target - x) - 2 w x'.
class Follower {
 public:
  /// @param bandwidth_hz  w / 2 pi
  Follower(const Vec3& start_m, double bandwidth_hz) noexcept
      : omega_(2 * std::numbers::pi * bandwidth_hz), place_m_(start_m) {}

  /// dt_s later, the target held.
  const Vec3& advance(const Vec3& target_m, double dt_s) noexcept {
    const double decay = std::exp(-omega_ * dt_s);
    const Vec3 offset = place_m_ - target_m;
    const Vec3 slope = velocity_m_per_s_ + omega_ * offset;
    place_m_ = target_m + (offset + slope * dt_s) * decay;
    velocity_m_per_s_ = (velocity_m_per_s_ - omega_ * slope * dt_s) * decay;
    return place_m_;
  }

  /// It was led elsewhere.
  void put(const Vec3& place_m, const Vec3& velocity_m_per_s) noexcept {
    place_m_ = place_m;
    velocity_m_per_s_ = velocity_m_per_s;
  }

  /// So long it is behind a target that goes on evenly.
  double lag_s() const noexcept { return 2 / omega_; }
  const Vec3& place_m() const noexcept { return place_m_; }
  const Vec3& velocity_m_per_s() const noexcept { return velocity_m_per_s_; }

 private:
  double omega_;
  Vec3 place_m_;
  Vec3 velocity_m_per_s_ = Vec3::Zero();
};

}  // namespace fingerpad
