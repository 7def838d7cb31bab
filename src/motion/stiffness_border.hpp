#pragma once

#include <cmath>

namespace fingerpad {

/// Stiffness at which `stable` ends, sought upwards from well below a guess: with dry friction there may be
/// quiet islands above it.
template <typename Stable>
double stiffness_border(double guess, double share, Stable stable) {
  constexpr double stride = 1.3;
  double low = guess / 2;
  for (int i = 0; !stable(low); ++i) {
    if (i == 40) return 0;
    low /= 4;
  }
  double high = low * stride;
  while (high < guess * 1e6 && stable(high)) {
    low = high;
    high *= stride;
  }
  while (high / low > 1 + share) {
    const double middle = std::sqrt(low * high);
    (stable(middle) ? low : high) = middle;
  }
  return std::sqrt(low * high);
}

}  // namespace fingerpad
