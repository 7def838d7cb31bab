#include "friction/stick_spring.hpp"

#include <cmath>

namespace fingerpad {

double cubic_spring_rho(double share, double cubic_share) noexcept {
  const double c = cubic_share;
  if (c <= 0) return share;
  const double p = (1 - c) / c;
  if (p <= 0) return std::cbrt(share);
  // The real root of the depressed cubic, by sinh.
  const double root = std::sqrt(p / 3);
  return 2 * root * std::sinh(std::asinh(share / c / (2 * root * root * root)) / 3);
}

}  // namespace fingerpad
