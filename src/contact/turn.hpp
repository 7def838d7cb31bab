#pragma once

#include <Eigen/Geometry>

#include "base/unit_vector.hpp"
#include "contact/proxy_limits.hpp"

namespace fingerpad {

/// The smallest rotation from one unit vector to another, as axis times the tangent of half the angle
/// (Rodrigues); none where they are opposite. A mean of such turns is no wider than the widest.
inline Vec3 turn_between(const Vec3& from, const Vec3& to) noexcept {
  if (differ_by_rounding_only(from, to)) return Vec3::Zero();
  const double sum = 1 + from.dot(to);
  return sum > ProxyLimits::least_turn_sum ? Vec3(from.cross(to) / sum) : Vec3::Zero();
}

/// A unit vector after a turn.
inline Vec3 turned(const Vec3& v, const Vec3& turn) noexcept {
  if (turn == Vec3::Zero()) return v;
  const Vec3 across = turn.cross(v);
  return v + 2 / (1 + turn.squaredNorm()) * (across + turn.cross(across));
}

}  // namespace fingerpad
