#include "motion/low_pass.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fingerpad {

ZeroPhaseLowPass::ZeroPhaseLowPass(double cutoff_hz, double rate_hz) noexcept {
  // The bilinear transform, with the cutoff where it belongs.
  const double w = std::tan(std::numbers::pi * cutoff_hz / rate_hz);
  const double scale = 1 + std::numbers::sqrt2 * w + w * w;
  gain_ = w * w / scale;
  a1_ = 2 * (w * w - 1) / scale;
  a2_ = (1 - std::numbers::sqrt2 * w + w * w) / scale;
  // The poles lose a factor of exp(-2 pi / sqrt 2) in a period of the cutoff: 5 of them leave 2e-10.
  memory_ = 5 * rate_hz / cutoff_hz + 10;
}

/// Begins as if the first sample had been there for ever.
void ZeroPhaseLowPass::run(Eigen::VectorXd& signal) const noexcept {
  if (signal.size() == 0) return;
  double x1 = signal[0], x2 = x1, y1 = x1, y2 = x1;
  for (double& sample : signal) {
    const double x = sample;
    sample = gain_ * (x + 2 * x1 + x2) - a1_ * y1 - a2_ * y2;
    x2 = x1;
    x1 = x;
    y2 = y1;
    y1 = sample;
  }
}

Eigen::VectorXd ZeroPhaseLowPass::filtered(const Eigen::VectorXd& signal) const {
  const Eigen::Index n = signal.size();
  if (n < 3) return signal;
  const Eigen::VectorXd line = Eigen::VectorXd::LinSpaced(n, signal[0], signal[n - 1]);
  const Eigen::VectorXd rest = signal - line;  // begins and ends at 0, so that its reflection is its negative
  const auto ahead = static_cast<Eigen::Index>(std::min(memory_, static_cast<double>(n - 1)));
  Eigen::VectorXd extended(n + 2 * ahead);
  extended << -rest.segment(1, ahead).reverse(), rest, -rest.segment(n - 1 - ahead, ahead).reverse();
  run(extended);
  extended.reverseInPlace();
  run(extended);
  extended.reverseInPlace();
  return line + extended.segment(ahead, n);
}

}  // namespace fingerpad
