#pragma once

#include <vector>

#include "base/types.hpp"

namespace fingerpad {

/// A trial's samples that press with half of its press or more, and those with less than a quarter, which are
/// as good as in the air. Those between are neither: the finger lands, or is lifted.
struct PressAndAir {
  std::vector<Eigen::Index> press, air;
};

/// @param forces_n  along the axis that presses
/// @param press_n   what the trial presses with, > 0
PressAndAir press_and_air(const Eigen::RowVectorXd& forces_n, double press_n);

/// Of a trial's forces, or heights, those at some of its samples.
std::vector<double> values_at(const Eigen::RowVectorXd& values, const std::vector<Eigen::Index>& samples);

/// Whether samples last long enough to say what a finger does in them: 20 ms.
bool last_long(const std::vector<Eigen::Index>& samples, double rate_hz) noexcept;

}  // namespace fingerpad
