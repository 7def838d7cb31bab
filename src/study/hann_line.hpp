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

/// The forces' windowed transform at one frequency, scaled so that a sine of amplitude 1 gives 1. Samples
/// that stand out, as those of ruptures, do not count.
class HannLine {
 public:
  HannLine(const RecordedTrial& trial, double mains_hz);

  bool is_empty() const noexcept { return !(sums_.minCoeff() > 0); }

  Phasors at(double frequency_hz) const;
  /// The powers of at() over a band.
  HumScan scan(double first_hz, double width_hz) const;

 private:
  std::vector<std::complex<double>> block_sums(Eigen::Index axis, double at_hz, Eigen::Index block) const;

  double rate_hz_;
  Points rest_, weighted_;
  Vec3 sums_ = Vec3::Zero();
};

}  // namespace fingerpad
