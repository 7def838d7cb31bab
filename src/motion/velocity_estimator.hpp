#pragma once

#include <array>
#include <utility>

#include "base/types.hpp"

namespace fingerpad {

/// Velocity from positions that an encoder has rounded to a quantum.
///
/// A plain difference of rounded positions jumps in steps of quantum/T: 0.3 m/s at 10 kHz and 0.03 mm, above
/// every speed that friction asks about. First-order adaptive windowing (Janabi-Sharifi, Hayward & Chen 2000,
/// the end-fit form) looks as far back as one straight line explains every position to within the quantum,
/// along each axis by itself: long windows at low speed, short ones where the finger turns. Without a quantum
/// it is the plain difference.
class VelocityEstimator {
 public:
  /// @param quantum_m  position quantum, >= 0
  /// @param dt_s       time between positions, > 0
  VelocityEstimator(double quantum_m, double dt_s) noexcept : quantum_m_(quantum_m), dt_s_(dt_s) {}

  /// Takes the position of this tick; its velocity [m/s]. Zero at the first. O(longest window), allocates
  /// nothing.
  Vec3 next(const Vec3& position_m) noexcept {
    if (quantum_m_ > 0) return next_of_quanta(position_m);
    const Vec3 last_m = std::exchange(ring_[0], position_m);
    if (std::exchange(count_, 1) == 0) return Vec3::Zero();
    return (position_m - last_m) / dt_s_;
  }
  void reset() noexcept { count_ = 0; }

 private:
  /// Ticks in the longest window: at 10 kHz and 0.03 mm it resolves 0.005 m/s.
  static constexpr int longest = 64;

  Vec3 next_of_quanta(const Vec3& position_m) noexcept;
  double axis_velocity(int axis) const noexcept;
  double past(int axis, int ticks) const noexcept;

  double quantum_m_, dt_s_;
  std::array<Vec3, longest + 1> ring_{};  // the last positions
  int newest_ = 0;
  int count_ = 0;  // positions held
};

}  // namespace fingerpad
