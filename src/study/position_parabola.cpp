#include "study/position_parabola.hpp"

namespace fingerpad {

std::optional<PositionParabola> position_parabola(const MeasuredTrial& trial, std::size_t middle,
                                                  std::size_t half, const Vec2& along) {
  if (middle < half || middle + half >= trial.position_m.size()) return std::nullopt;
  const Vec2 origin = trial.position_m[middle];
  double squares = 0, fourths = 0, sum = 0, first = 0, second = 0;
  for (std::size_t i = middle - half; i <= middle + half; ++i) {
    if (i > middle - half && trial.starts_anew[i]) return std::nullopt;
    const double t = static_cast<double>(i) - static_cast<double>(middle),
                 s = (trial.position_m[i] - origin).dot(along);
    squares += t * t;
    fourths += t * t * t * t;
    sum += s;
    first += t * s;
    second += t * t * s;
  }
  const double count = 2 * static_cast<double>(half) + 1;
  PositionParabola found;
  found.bend_m = (second - squares / count * sum) / (fourths - squares * squares / count);
  found.slope_m = first / squares;
  found.place_m = sum / count - found.bend_m * squares / count + origin.dot(along);
  return found;
}

}  // namespace fingerpad
