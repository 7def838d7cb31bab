#include "view/axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

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

double Axis::value_at(double share) const {
  if (logarithmic) return min * std::pow(max / min, share);
  return min + (max - min) * share;
}

double least_span(std::string_view label) noexcept {
  struct Floor {
    std::string_view unit;
    double span;
  };
  static constexpr Floor floors[] = {{"[mm]", 1e-3},   {"[N]", 1e-3},   {"[1]", 1e-3},
                                     {"[mm/s]", 1e-2}, {"[deg]", 1e-2}, {"[m]", 1e-6}};
  for (const Floor& floor : floors) {
    if (label.ends_with(floor.unit)) return floor.span;
  }
  return 0;
}

namespace {

/// A multiple of a step, with as many digits as tell it from the next: of a clock that counts from 1970, too.
std::string mark_label(double value, double step) {
  constexpr double told_by_six_digits = 1e5;
  if (!(std::abs(value) > told_by_six_digits * step)) return plain_number(value);
  const int decimals = std::max(0, -static_cast<int>(std::floor(std::log10(step) + 1e-9)));
  return fmt::format("{:.{}f}", value, decimals);
}

void mark_multiples(Axis& axis, double step) {
  axis.marks.clear();
  axis.labels.clear();
  for (double k = std::ceil(axis.min / step - 1e-9); k * step <= axis.max + 1e-9 * step; ++k) {
    axis.marks.push_back(k * step);
    axis.labels.push_back(mark_label(std::abs(k) < 0.5 ? 0 : k * step, step));
  }
}

/// A finer ladder, or where that is too many its ends: a single number tells no scale. Where zero is between
/// them it takes the place of the one that is nearer to it: what a sign means is read off it.
void mark_twice(Axis& axis, double step, int most_marks) {
  while (axis.marks.size() < 2) {
    step = round_down_125(step / 1.9);
    mark_multiples(axis, step);
  }
  if (static_cast<int>(axis.marks.size()) <= most_marks) return;
  std::size_t first = 0, last = axis.marks.size() - 1;
  const auto zero = std::find(axis.labels.begin(), axis.labels.end(), "0");
  const bool is_between = axis.marks[first] < 0 && axis.marks[last] > 0;
  if (is_between && zero != axis.labels.end()) {
    const auto place = static_cast<std::size_t>(zero - axis.labels.begin());
    (-axis.marks[first] > axis.marks[last] ? last : first) = place;
  }
  axis.marks = {axis.marks[first], axis.marks[last]};
  axis.labels = {axis.labels[first], axis.labels[last]};
}

}  // namespace

Axis linear_axis(double min, double max, int most_marks) {
  Axis axis;
  const double greatest = std::max(std::abs(min), std::abs(max));
  if (!(max - min > 1e-12 * greatest)) {  // marks so near one another are the same number
    const double half = std::max(std::abs(min) * 0.05, 1e-3);
    min -= half;
    max += half;
  }
  double step = round_down_125((max - min) / std::max(1, most_marks));
  while ((max - min) / step > most_marks) step = round_down_125(step * 2.6);
  axis.min = min;
  axis.max = max;
  mark_multiples(axis, step);
  if (axis.marks.size() < 2) mark_twice(axis, step, most_marks);
  return axis;
}

namespace {

std::string log_label(double step, int power) {
  return power < -3 || power > 5 ? fmt::format("{}e{}", step, power)
                                 : plain_number(step * std::pow(10.0, power));
}

/// Marks at these steps of every `every`-th power of ten; what stays between them is minor.
void mark_powers(Axis& axis, std::span<const double> steps, int every) {
  const double reach = 1 + 1e-9;  // an end that is a mark but for rounding keeps it
  const auto within = [&](double value) { return value * reach >= axis.min && value <= axis.max * reach; };
  const int first = static_cast<int>(std::floor(std::log10(axis.min)));
  const int last = static_cast<int>(std::floor(std::log10(axis.max) + 1e-9));
  for (int k = first; k <= last; ++k) {
    const double power = std::pow(10.0, k);
    for (int step = 1; step <= 9; ++step) {
      if (!within(step * power)) continue;
      const bool marked = k % every == 0 && std::find(steps.begin(), steps.end(), step) != steps.end();
      if (marked) {
        axis.marks.push_back(step * power);
        axis.labels.push_back(log_label(step, k));
      } else if (every == 1 || step == 1) {
        axis.minor_marks.push_back(step * power);
      }
    }
  }
}

}  // namespace

Axis log_axis(double min, double max, int most_marks) {
  constexpr double within_decade[] = {1, 2, 5}, decades_alone[] = {1};
  const double decades = std::log10(max / min);
  Axis axis{min, max, true, {}, {}, {}};
  if (decades < 0.7) {
    Axis linear = linear_axis(min, max, most_marks);
    linear.logarithmic = true;
    return linear;
  }
  mark_powers(axis, within_decade, 1);
  if (static_cast<int>(axis.marks.size()) <= most_marks + 1) return axis;
  axis = {min, max, true, {}, {}, {}};
  mark_powers(axis, decades_alone, std::max(1, static_cast<int>(std::ceil(decades / most_marks))));
  return axis;
}

Axis decade_axis(double min, double max, int most_marks) {
  const double first = std::floor(std::log10(min) + 1e-9);
  const double last = std::max(first + 1, std::ceil(std::log10(max) - 1e-9));
  return log_axis(std::pow(10.0, first), std::pow(10.0, last), most_marks);
}

}  // namespace fingerpad
