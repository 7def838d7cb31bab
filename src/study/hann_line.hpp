#pragma once

#include <array>
#include <complex>
#include <vector>

#include "study/recorded_trial.hpp"

namespace fingerpad {

using Phasors = std::array<std::complex<double>, 3>;  ///< of the axes

/// Powers of all axes together, at first_hz, first_hz + step_hz, and so on.
struct HumScan {
  double first_hz = 0, step_hz = 0;
  std::vector<double> power;
};

/// What of a trial hums: its forces [N] or its torques [N m], both 3 x n.
using Sensed = Points RecordedTrial::*;

/// The windowed transform of forces or torques at one frequency, scaled so that a sine of amplitude 1
/// gives 1. Samples that stand out, as those of ruptures, do not count, nor do those that were not recorded.
class HannLine {
 public:
  HannLine(const RecordedTrial& trial, Sensed sensed, double mains_hz);

  bool is_empty() const noexcept { return !(sums_.minCoeff() > 0); }

  /// Of each axis, its phase that of sample 0.
  Phasors at(double frequency_hz) const;
  /// The powers of at() over a band.
  HumScan scan(double first_hz, double width_hz) const;
  /// What the line is looked for in: less what moves slowly. 3 x n.
  const Points& rest() const noexcept { return rest_; }
  bool counts(Eigen::Index axis, Eigen::Index i) const {
    return counts_[static_cast<std::size_t>(axis)][static_cast<std::size_t>(i)];
  }

 private:
  std::vector<std::complex<double>> block_sums(Eigen::Index axis, double at_hz, Eigen::Index block) const;

  double rate_hz_;
  Points rest_, weighted_;
  Vec3 sums_ = Vec3::Zero();
  std::array<std::vector<bool>, 3> counts_;
};

}  // namespace fingerpad
