#pragma once

#include "base/types.hpp"

namespace fingerpad {

/// Whether two unit vectors are the same but for their last bits: shaded normals of a flat face are.
inline bool differ_by_rounding_only(const Vec3& a, const Vec3& b) noexcept {
  return (a - b).squaredNorm() < 1e-30;
}

/// v over its length; zero of a vector without one.
inline Vec3 unit_or_zero(const Vec3& v) noexcept {
  const double length = v.norm();
  return length > 0 ? Vec3(v / length) : Vec3::Zero();
}

}  // namespace fingerpad
