#pragma once

#include <algorithm>
#include <cmath>

#include "base/types.hpp"

namespace fingerpad {

/// |v| without overflow or underflow on the way; the plain root wherever that is safe.
inline double length(const Vec2& v) noexcept {
  const double square = v.x() * v.x() + v.y() * v.y();
  if (square > 1e-280 && square < 1e280) return std::sqrt(square);
  return std::hypot(v.x(), v.y());
}

/// v/|v|, for the tiniest and the largest v; zero for zero.
inline Vec2 direction_of(const Vec2& v) noexcept {
  const double square = v.x() * v.x() + v.y() * v.y();
  if (square > 1e-280 && square < 1e280) return v / std::sqrt(square);
  const double largest = std::max(std::abs(v.x()), std::abs(v.y()));
  if (largest == 0) return Vec2::Zero();
  const Vec2 scaled(v.x() / largest, v.y() / largest);
  return scaled / std::sqrt(scaled.x() * scaled.x() + scaled.y() * scaled.y());
}

/// v, shortened to `limit` where it is longer (by more than rounding: a vector once shortened stays as it
/// is).
inline Vec2 shortened(const Vec2& v, double limit) noexcept {
  const double square = v.x() * v.x() + v.y() * v.y();
  if (limit > 1e-140 && square <= limit * limit * (1 + 4e-15)) return v;
  return length(v) > limit ? Vec2(direction_of(v) * limit) : v;
}

}  // namespace fingerpad
