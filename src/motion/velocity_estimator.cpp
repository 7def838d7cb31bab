#include "motion/velocity_estimator.hpp"

#include <algorithm>

namespace fingerpad {

double VelocityEstimator::past(int axis, int ticks) const noexcept {
  constexpr int size = longest + 1;
  return ring_[static_cast<std::size_t>((newest_ - ticks + size) % size)][axis];
}

double VelocityEstimator::axis_velocity(int axis) const noexcept {
  const double now = past(axis, 0);
  double velocity = (now - past(axis, 1)) / dt_s_;
  // Slopes that pass every position so far within the quantum; a little more, so that rounding does not close
  // the band on positions that lie exactly a quantum off.
  const double band_m = quantum_m_ * (1 + 1e-9);
  double lowest = velocity - band_m / dt_s_, highest = velocity + band_m / dt_s_;
  for (int n = 2; n < count_; ++n) {
    const double span_s = n * dt_s_;
    const double slope = (now - past(axis, n)) / span_s;
    if (slope < lowest || slope > highest) break;
    velocity = slope;
    lowest = std::max(lowest, slope - band_m / span_s);
    highest = std::min(highest, slope + band_m / span_s);
  }
  return velocity;
}

Vec3 VelocityEstimator::next_of_quanta(const Vec3& position_m) noexcept {
  newest_ = (newest_ + 1) % (longest + 1);
  ring_[static_cast<std::size_t>(newest_)] = position_m;
  count_ = std::min(count_ + 1, longest + 1);
  if (count_ < 2) return Vec3::Zero();
  return {axis_velocity(0), axis_velocity(1), axis_velocity(2)};
}

}  // namespace fingerpad
