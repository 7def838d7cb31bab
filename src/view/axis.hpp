#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace fingerpad {

/// A chart's axis: what it spans and where it is marked.
struct Axis {
  double min = 0, max = 1;
  bool logarithmic = false;
  std::vector<double> marks;
  std::vector<std::string> labels;  ///< one a mark
  std::vector<double> minor_marks;  ///< between the marks, without labels

  /// 0 at min, 1 at max.
  double share(double value) const;
  double value_at(double share) const;
};

/// The least that a linear axis spans, in the unit that its label ends with in brackets: a thousandth of a
/// millimetre, a newton, or 1; a hundredth of a mm/s or a degree; 1e-6 m. What differs by less is rounding,
/// and is drawn flat. 0 for any other unit.
double least_span(std::string_view label) noexcept;

/// An axis over these values with marks at multiples of 1, 2 or 5 times a power of ten, at most `most_marks`
/// and one; at least two.
Axis linear_axis(double min, double max, int most_marks);

/// A logarithmic axis over these values with marks at 1, 2 and 5 times the powers of ten where at most
/// `most_marks` and one come of it, else at powers of ten; within less than a decade as a linear axis.
/// @pre 0 < min < max
Axis log_axis(double min, double max, int most_marks);

/// A logarithmic axis over whole decades. @pre 0 < min <= max
Axis decade_axis(double min, double max, int most_marks);

/// The largest 1, 2 or 5 times a power of ten that is not above `value`, > 0.
double round_down_125(double value);

/// A number as a person would write it: 0.05, 10, 2000.
std::string plain_number(double value);

}  // namespace fingerpad
