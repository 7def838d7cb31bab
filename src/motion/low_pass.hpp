#pragma once

#include <Eigen/Core>

namespace fingerpad {

/// A low pass without delay, for what is recorded whole: a Butterworth filter of second order, run forth and
/// then back.
///
/// The amplitude of a sine of `cutoff_hz` is halved (-6 dB: -3 dB each way), of one far above falls with the
/// fourth power of its frequency, and nothing is shifted in time. The straight line from the first sample to
/// the last passes as it is, and the signal is continued at both ends by its reflection through the end
/// point, as far as the filter remembers: ends neither ring nor sag, and a steady motion is not changed.
class ZeroPhaseLowPass {
 public:
  /// @pre 0 < cutoff_hz < rate_hz / 2
  ZeroPhaseLowPass(double cutoff_hz, double rate_hz) noexcept;

  /// @param signal  samples at the rate
  Eigen::VectorXd filtered(const Eigen::VectorXd& signal) const;

 private:
  void run(Eigen::VectorXd& signal) const noexcept;

  double gain_, a1_, a2_;  // y = gain (x + 2 x' + x'') - a1 y' - a2 y''
  double memory_;          // samples after which nothing is left of what was
};

}  // namespace fingerpad
