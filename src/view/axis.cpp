#include "view/axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace fingerpad {

double round_down_125(double value) {
  const double decade = std::pow(10.0, std::floor(std::log10(value)));
  for (const double step : {5.0, 2.0}) {
    if (value >= step * decade * (1 - 1e-12)) return step * decade;
  }
  return decade;
}

std::string plain_number(double value) {
  return fmt::format("{:.6g}", value == 0 ? 0.0 : value);
}

double Axis::share(double value) const {
  if (logarithmic) return std::log(value / min) / std::log(max / min);
  return (value - min) / (max - min);
}

Axis linear_axis(double min, double max, int most_marks) {
  Axis axis;
  if (!(max > min)) {
    const double half = std::max(std::abs(min) * 0.05, 1e-3);
    min -= half;
    max += half;
  }
  double step = round_down_125((max - min) / std::max(1, most_marks));
  while ((max - min) / step > most_marks) step = round_down_125(step * 2.6);
  axis.min = min;
  axis.max = max;
  for (double k = std::ceil(axis.min / step - 1e-9); k * step <= axis.max + 1e-9 * step; ++k) {
    axis.marks.push_back(k * step);
    axis.labels.push_back(plain_number(std::abs(k) < 0.5 ? 0 : k * step));
  }
  return axis;
}

Axis decade_axis(double min, double max, int most_marks) {
  Axis axis;
  axis.logarithmic = true;
  const int first = static_cast<int>(std::floor(std::log10(min) + 1e-9));
  const int last = std::max(first + 1, static_cast<int>(std::ceil(std::log10(max) - 1e-9)));
  axis.min = std::pow(10.0, first);
  axis.max = std::pow(10.0, last);
  const int every = std::max(1, (last - first + most_marks - 1) / most_marks);
  for (int k = first; k <= last; k += every) {
    axis.marks.push_back(std::pow(10.0, k));
    axis.labels.push_back(k >= -2 && k <= 3 ? plain_number(axis.marks.back()) : fmt::format("1e{}", k));
  }
  return axis;
}

}  // namespace fingerpad
