#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace fingerpad {

/// What a trial alone says of a number, and the load that it says it of.
struct OwnNumber {
  std::size_t trial = 0;
  double value = 0;
  double log_load = std::numeric_limits<double>::quiet_NaN();  ///< mean of ln(n/1 N); no number: not known

  /// How many times it is what it would be at another load, were it to go with n^exponent.
  double times_that_at(double other_log_load, double exponent) const;
};

/// Exponents of a number's law over the load, from the least to the greatest that trials leave likely.
struct ExponentRange {
  double least = 0, most = 0;
};

/// Tells how a number goes with the load by the slopes of its logarithm between any two trials of a group:
/// from their lower to their upper quartile (as Theil 1950 and Sen 1968 take the median), each counting as
/// much as the loads differ. Trials that are off move the quartiles little, as long as they are few; where
/// they are not, or trials are few, the range is wide. 0 to 0 where no two loads of a group differ by 5 %.
/// @param groups  trials that differ by load and chance alone; what they share is the exponent
ExponentRange likely_exponents(const std::vector<std::vector<OwnNumber>>& groups);

/// The exponents by which a trial may be judged: those that the other trials leave likely, with any one of
/// them left out too, and no wider than -1 to 1, which a finger's numbers keep to. Where they leave none
/// likely, as they are of one load, it is those. A trial at the end of the loads would else bend the law by
/// which it is judged, and one that is off pass for the load's. 0 to 0 where no two loads of a group differ
/// by 5 %.
ExponentRange exponents_beside(const std::vector<std::vector<OwnNumber>>& groups, std::size_t trial);

/// Their median; nothing where no two loads of a group differ by 5 %.
std::optional<double> median_slope(const std::vector<std::vector<OwnNumber>>& groups);

}  // namespace fingerpad
