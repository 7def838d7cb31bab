#pragma once

#include <cmath>

#include "fingerpad/finger_sample.hpp"
#include "touch/skin_motion.hpp"

namespace fingerpad {

/// Beyond this a position (in m), velocity or force is a broken input, not a finger: products of a few such
/// numbers must stay far from overflow.
inline constexpr double largest_meaningful = 1e60;

inline bool meaningful(const Vec3& v) noexcept {
  // Of what is no number neither is true.
  return std::abs(v.x()) <= largest_meaningful && std::abs(v.y()) <= largest_meaningful &&
         std::abs(v.z()) <= largest_meaningful;
}

/// The velocity that the motion knows, or else the one that its positions show.
inline Vec3 velocity_of(const FingerSample& sample, const Vec3& shown_W) noexcept {
  return sample.velocity_W && meaningful(*sample.velocity_W) ? *sample.velocity_W : shown_W;
}

/// None where it is no number.
inline double usable_force_n(double measured_n) noexcept {
  return measured_n > 0 && measured_n <= largest_meaningful ? measured_n : 0;
}

/// How a sample's finger stands, with a unit direction (straight down the normal where its own is unusable)
/// and a finite push.
inline FingerStand stand_of(const FingerSample& sample, const Vec3& normal_W) noexcept {
  const double length = sample.direction_W.norm();
  return {sample.p_WQ,
          std::isfinite(length) && length > 0 ? Vec3(sample.direction_W / length) : Vec3(-normal_W),
          meaningful(sample.push_W_n) ? sample.push_W_n : Vec3::Zero()};
}

}  // namespace fingerpad
