#include "friction/slip_vibration.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fingerpad {

SlipVibration::SlipVibration(double frequency_hz, double bandwidth_hz, double dt_s,
                             const RandomStream& stream) noexcept
    : stream_(stream) {
  constexpr double pi = std::numbers::pi;
  const double r = std::exp(-pi * bandwidth_hz * dt_s);
  const double r2 = r * r;
  const double one_less_r2 = -std::expm1(-2 * pi * bandwidth_hz * dt_s);
  // The spectrum of an AR(2) of poles r e^(+-i theta) peaks at cos w = (1 + r^2)/(2 r) cos theta: the poles
  // are put where that is at frequency_hz.
  const double cosine = 2 * r / (1 + r2) * std::cos(2 * pi * frequency_hz * dt_s);
  feedback_1_ = 2 * r * cosine;
  feedback_2_ = -r2;
  // Stationary variance set to 1: g^2 = (1 - r^2)((1 + r^2)^2 - feedback_1^2)/(1 + r^2); the middle factor
  // is (1 - r^2)^2 + 4 r^2 sin^2(theta), and sin^2(theta) = ((1 - r^2)^2 + 4 r^2 sin^2(w))/(1 + r^2)^2.
  const double peak_sine = std::sin(2 * pi * frequency_hz * dt_s);
  const double sine2 = (one_less_r2 * one_less_r2 + 4 * r2 * peak_sine * peak_sine) / ((1 + r2) * (1 + r2));
  gain_ = std::sqrt(one_less_r2 * (one_less_r2 * one_less_r2 + 4 * r2 * sine2) / (1 + r2));
  correlation_ = feedback_1_ / (1 + r2);
}

double SlipVibration::next() noexcept {
  if (!slipping_) {
    slipping_ = true;
    before_ = stream_.normal();
    last_ =
        correlation_ * before_ + std::sqrt(std::max(0.0, 1 - correlation_ * correlation_)) * stream_.normal();
    return last_;
  }
  const double x = feedback_1_ * last_ + feedback_2_ * before_ + gain_ * stream_.normal();
  before_ = last_;
  last_ = x;
  return x;
}

double vibration_force_scale(double amplitude, double signal) noexcept {
  return std::max(0.0, 1 + amplitude * signal);
}

}  // namespace fingerpad
