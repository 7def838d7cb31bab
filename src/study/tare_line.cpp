#include "study/tare_line.hpp"

#include <algorithm>

namespace fingerpad {
namespace {

/// A line through an axis' samples.
struct TareLine {
  double middle = 0, level_n = 0, slope_n = 0;
  double at(double i) const noexcept { return level_n + slope_n * (i - middle); }
};

TareLine line_through(const Points& sensed, Eigen::Index axis, const std::vector<Eigen::Index>& samples,
                      bool takes_slope) {
  TareLine line;
  const auto count = static_cast<double>(samples.size());
  for (const Eigen::Index i : samples) {
    line.middle += static_cast<double>(i) / count;
    line.level_n += sensed(axis, i) / count;
  }
  double squares = 0, drift = 0;
  for (const Eigen::Index i : samples) {
    const double off = static_cast<double>(i) - line.middle;
    squares += off * off;
    drift += off * (sensed(axis, i) - line.level_n);
  }
  if (takes_slope && squares > 0) line.slope_n = drift / squares;
  return line;
}

}  // namespace

Tare::Tare(const Points& sensed, const std::vector<Eigen::Index>& free)
    : last(static_cast<double>(std::max<Eigen::Index>(sensed.cols() - 1, 1))) {
  const bool takes_slope = 3 * (free.back() - free.front()) > sensed.cols();
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const TareLine line = line_through(sensed, axis, free, takes_slope);
    begin_n[axis] = line.at(0);
    end_n[axis] = line.at(last);
  }
}

}  // namespace fingerpad
