#include "study/ringing.hpp"

#include <algorithm>
#include <cmath>

namespace fingerpad {

void Ringing::Window::take(double value) noexcept {
  min = count > 0 ? std::min(min, value) : value;
  max = count > 0 ? std::max(max, value) : value;
  ++count;
  const double off = value - mean;
  mean += off / static_cast<double>(count);
  square += off * (value - mean);
}

double Ringing::Window::spread() const noexcept {
  return count > 0 ? std::sqrt(square / static_cast<double>(count)) : 0;
}

void Ringing::observe(double value) noexcept {
  const long tenth = 10 * seen_ / std::max(1L, ticks_);
  if (tenth < 1) early_.take(value);
  if (tenth >= 4 && tenth < 6) middle_.take(value);
  if (tenth >= 8) late_.take(value);
  ++seen_;
}

bool Ringing::dies_out() const noexcept {
  // A signal at rest holds nothing but rounding.
  if (late_.spread() <= 1e-9 * early_.spread()) return true;
  // A limit cycle keeps its spread; the slowest decay that counts loses a thousandth over the run.
  return late_.spread() < 0.999 * middle_.spread();
}

}  // namespace fingerpad
