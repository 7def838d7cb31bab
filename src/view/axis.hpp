#pragma once

#include <string>
#include <vector>

namespace fingerpad {

/// A chart's axis: what it spans and where it is marked.
struct Axis {
  double min = 0, max = 1;
  bool logarithmic = false;
  std::vector<double> marks;
  std::vector<std::string> labels;  ///< one a mark

  /// 0 at min, 1 at max.
  double share(double value) const;
};

/// An axis over these values with marks at multiples of 1, 2 or 5 times a power of ten, at most `most_marks`
/// and one.
Axis linear_axis(double min, double max, int most_marks);

/// A logarithmic axis over whole decades. @pre 0 < min <= max
Axis decade_axis(double min, double max, int most_marks);

/// The largest 1, 2 or 5 times a power of ten that is not above `value`, > 0.
double round_down_125(double value);

/// A number as a person would write it: 0.05, 10, 2000.
std::string plain_number(double value);

}  // namespace fingerpad
