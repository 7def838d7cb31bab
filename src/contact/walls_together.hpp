#pragma once

#include <array>

#include "base/types.hpp"

namespace fingerpad {

/// Up to three walls as one: what their normals alone fix of every projection onto all of them.
class WallsTogether {
 public:
  WallsTogether() = default;
  /// @param normals  unit; the first `count` are read
  WallsTogether(const std::array<Vec3, 3>& normals, int count) noexcept;

  /// Whether the walls fix the multipliers: no two of them are parallel to 1e-8, no three of them flat.
  bool fix_shares() const noexcept { return fix_shares_; }

  /// The multipliers [m] that put a point onto every wall.
  /// @param lack_m  how far it is behind each
  /// @pre fix_shares()
  std::array<double, 3> shares_m(const std::array<double, 3>& lack_m) const noexcept {
    if (count_ < 2) return lack_m;
    if (count_ == 2) {
      // The 2 x 2 system, written so that nearly equal normals cancel nothing but the missing lengths.
      const double apart_m = (lack_m[0] - turn_ * lack_m[1]) * per_sine2_;
      return {apart_m + turn_ * lack_m[1] * common_, turn_ * (lack_m[0] * common_ - apart_m), 0};
    }
    const Vec3 shift_m = lack_m[0] * dual_[0] + lack_m[1] * dual_[1] + lack_m[2] * dual_[2];
    return {shift_m.dot(dual_[0]), shift_m.dot(dual_[1]), shift_m.dot(dual_[2])};
  }

 private:
  int count_ = 0;
  bool fix_shares_ = true;
  double turn_ = 1, common_ = 0, per_sine2_ = 0;  // of two: the sign of the cosine, 1/(1 + |cosine|), ...
  std::array<Vec3, 3> dual_;                      // of three: 1 along its own normal, 0 along the others
};

}  // namespace fingerpad
