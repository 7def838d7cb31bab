#include "study/press_and_air.hpp"

#include <algorithm>

namespace fingerpad {

PressAndAir press_and_air(const Eigen::RowVectorXd& forces_n, double press_n) {
  constexpr double pressed = 0.5, in_air = 0.25;
  PressAndAir samples;
  for (Eigen::Index i = 0; i < forces_n.size(); ++i) {
    if (forces_n[i] >= pressed * press_n) samples.press.push_back(i);
    if (forces_n[i] < in_air * press_n) samples.air.push_back(i);
  }
  return samples;
}

std::vector<double> values_at(const Eigen::RowVectorXd& values, const std::vector<Eigen::Index>& samples) {
  std::vector<double> some;
  some.reserve(samples.size());
  for (const Eigen::Index i : samples) some.push_back(values[i]);
  return some;
}

bool last_long(const std::vector<Eigen::Index>& samples, double rate_hz) noexcept {
  constexpr double least_s = 0.02;
  return static_cast<double>(samples.size()) >= std::max(1.0, least_s * rate_hz);
}

}  // namespace fingerpad
