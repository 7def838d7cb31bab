#pragma once

#include <algorithm>
#include <cmath>

#include "base/types.hpp"

namespace fingerpad {

/// A 2-vector for the arithmetic within a law. Eigen's would do it too, but goes through memory wherever its
/// parts are used one by one, which makes most of a law's cost.
class PlaneVector {
 public:
  PlaneVector() = default;
  PlaneVector(double x, double y) noexcept : x_(x), y_(y) {}
  PlaneVector(const Vec2& v) noexcept : x_(v.x()), y_(v.y()) {}
  operator Vec2() const noexcept { return {x_, y_}; }

  double x() const noexcept { return x_; }
  double y() const noexcept { return y_; }
  double dot(const PlaneVector& other) const noexcept { return x_ * other.x_ + y_ * other.y_; }
  double square() const noexcept { return x_ * x_ + y_ * y_; }

  friend PlaneVector operator+(const PlaneVector& a, const PlaneVector& b) noexcept {
    return {a.x_ + b.x_, a.y_ + b.y_};
  }
  friend PlaneVector operator-(const PlaneVector& a, const PlaneVector& b) noexcept {
    return {a.x_ - b.x_, a.y_ - b.y_};
  }
  friend PlaneVector operator-(const PlaneVector& v) noexcept { return {-v.x_, -v.y_}; }
  friend PlaneVector operator*(double factor, const PlaneVector& v) noexcept {
    return {factor * v.x_, factor * v.y_};
  }
  friend PlaneVector operator*(const PlaneVector& v, double factor) noexcept { return factor * v; }
  friend PlaneVector operator/(const PlaneVector& v, double divisor) noexcept {
    return {v.x_ / divisor, v.y_ / divisor};
  }

 private:
  double x_ = 0, y_ = 0;
};

/// A vector as its length and its direction; both zero for zero.
struct Polar {
  double length = 0;
  PlaneVector direction;
};

/// For squares that overflow, underflow or vanish. By value: else every vector would live in memory for it.
[[gnu::noinline, gnu::cold]] inline Polar extreme_polar(PlaneVector v) noexcept {
  const double largest = std::max(std::abs(v.x()), std::abs(v.y()));
  if (largest == 0) return {};
  const PlaneVector scaled(v.x() / largest, v.y() / largest);
  const double scaled_length = std::sqrt(scaled.square());
  return {largest * scaled_length, scaled / scaled_length};
}

/// Whether a sum of two squares has lost nothing to overflow or underflow.
inline bool is_plain_square(double square) noexcept {
  return square > 1e-280 && square < 1e280;
}

/// |v| and v/|v|, for the tiniest and the largest v.
inline Polar polar(const PlaneVector& v) noexcept {
  const double square = v.square();
  if (!is_plain_square(square)) [[unlikely]]
    return extreme_polar(v);
  const double length = std::sqrt(square);
  return {length, v / length};
}

/// |v| without overflow or underflow on the way; the plain root wherever that is safe.
inline double length(const PlaneVector& v) noexcept {
  const double square = v.square();
  if (!is_plain_square(square)) [[unlikely]]
    return extreme_polar(v).length;
  return std::sqrt(square);
}

/// v/|v|; zero for zero.
inline PlaneVector direction_of(const PlaneVector& v) noexcept {
  return polar(v).direction;
}

/// Whether |v| > limit, without a root where that is safe.
/// @pre limit >= 0
inline bool is_longer(const PlaneVector& v, double limit) noexcept {
  const double square = v.square();
  if (is_plain_square(square) && limit > 1e-140 && limit < 1e140) [[likely]]
    return square > limit * limit;
  return extreme_polar(v).length > limit;
}

/// v, shortened to `limit` where it is longer (by more than rounding: a vector once shortened stays as it
/// is).
inline PlaneVector shortened(const PlaneVector& v, double limit) noexcept {
  const double square = v.square();
  if (limit > 1e-140 && square <= limit * limit * (1 + 4e-15)) [[likely]]
    return v;
  const Polar p = polar(v);
  return p.length > limit ? p.direction * limit : v;
}

}  // namespace fingerpad
