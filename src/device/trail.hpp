#pragma once

#include <array>

#include "base/types.hpp"

namespace fingerpad {

/// The way back out of where a finger has gone: places a step apart, loops cut off. Holds a thousand; of a
/// longer way the end is forgotten.
class Trail {
 public:
  explicit Trail(double step_m) noexcept : step_m_(step_m) {}

  /// Here nothing is in the way any more.
  void begin(const Vec3& place_W) noexcept {
    places_[0] = place_W;
    count_ = 1;
  }

  /// O(length), each step once; allocates nothing.
  void add(const Vec3& place_W) noexcept {
    if (count_ > 0 && (place_W - places_[count_ - 1]).norm() < step_m_) return;
    for (std::size_t i = 0; i < count_; ++i) {
      if ((place_W - places_[i]).norm() < step_m_) {
        count_ = i + 1;
        return;
      }
    }
    if (count_ < places_.size()) places_[count_++] = place_W;
  }

  /// Where to go next on the way back; the farthest place that is known once all are passed.
  const Vec3& back_from(const Vec3& place_W) noexcept {
    while (count_ > 1 && (place_W - places_[count_ - 1]).norm() < 0.5 * step_m_) --count_;
    return places_[count_ - 1];
  }

  /// From a place back to its beginning, about.
  double length_m(const Vec3& place_W) const noexcept {
    return static_cast<double>(count_) * step_m_ + (place_W - places_[count_ - 1]).norm();
  }

 private:
  double step_m_;
  std::array<Vec3, 1024> places_;
  std::size_t count_ = 0;
};

}  // namespace fingerpad
