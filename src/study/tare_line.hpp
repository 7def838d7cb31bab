#pragma once

#include <vector>

#include "base/types.hpp"

namespace fingerpad {

/// What a sensor reads by itself: a straight line in time on each axis; a constant, where the samples do not
/// span a third of the trial.
struct Tare {
  Vec3 begin_n, end_n;
  double last;  ///< sample

  /// @param sensed  forces or torques
  /// @param free    samples without contact, in order; some
  Tare(const Points& sensed, const std::vector<Eigen::Index>& free);
  Vec3 at(Eigen::Index i) const { return begin_n + (static_cast<double>(i) / last) * (end_n - begin_n); }
};

}  // namespace fingerpad
