#include "motion/pressed_force.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace fingerpad {

double pressed_median_n(std::span<const double> force_n) {
  std::vector<double> sizes(force_n.begin(), force_n.end());
  for (double& size : sizes) size = std::abs(size);
  std::sort(sizes.begin(), sizes.end());
  const double least_n = 0.25 * sizes[(sizes.size() - 1) * 99 / 100];
  std::vector<double> pressed;
  for (const double one_n : force_n)
    if (std::abs(one_n) >= least_n) pressed.push_back(one_n);
  const auto middle = pressed.begin() + static_cast<std::ptrdiff_t>(pressed.size() / 2);
  std::nth_element(pressed.begin(), middle, pressed.end());
  return *middle;
}

void turn_to_finger(std::span<double> normal_force_n) {
  if (normal_force_n.empty() || !(pressed_median_n(normal_force_n) < 0)) return;
  for (double& one_n : normal_force_n) one_n = -one_n;
}

}  // namespace fingerpad
