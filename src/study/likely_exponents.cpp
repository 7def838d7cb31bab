#include "study/likely_exponents.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fingerpad {
namespace {

/// Between two trials, and how much it counts.
struct LoadSlope {
  double slope = 0, apart = 0;
};

void add_slopes(const std::vector<OwnNumber>& group, std::vector<LoadSlope>& slopes) {
  constexpr double least_apart = 0.05;        // of ln n: else the slope is chance
  constexpr std::size_t most_pairs = 500000;  // of a group: of more an even choice tells as well
  const std::size_t pairs = group.size() * (group.size() - 1) / 2, every = pairs / most_pairs + 1;
  std::size_t pair = 0;
  for (std::size_t i = 0; i < group.size(); ++i) {
    for (std::size_t j = i + 1; j < group.size(); ++j) {
      if (pair++ % every != 0) continue;
      const double apart = group[j].log_load - group[i].log_load;
      if (!(std::abs(apart) > least_apart) || !(group[i].value > 0) || !(group[j].value > 0)) continue;
      slopes.push_back({std::log(group[j].value / group[i].value) / apart, std::abs(apart)});
    }
  }
}

/// Slopes between any two trials of a group, each counting as much as the loads differ.
class LoadSlopes {
 public:
  explicit LoadSlopes(const std::vector<std::vector<OwnNumber>>& groups) {
    for (const std::vector<OwnNumber>& group : groups)
      if (!group.empty()) add_slopes(group, slopes_);
    std::sort(slopes_.begin(), slopes_.end(),
              [](const LoadSlope& a, const LoadSlope& b) { return a.slope < b.slope; });
    for (const LoadSlope& one : slopes_) all_ += one.apart;
  }
  bool is_empty() const { return slopes_.empty(); }
  /// The slope below which a share of them lies.
  double below(double share) const {
    double sum = 0;
    for (const LoadSlope& one : slopes_)
      if ((sum += one.apart) >= share * all_) return one.slope;
    return slopes_.back().slope;
  }

 private:
  std::vector<LoadSlope> slopes_;
  double all_ = 0;
};

}  // namespace

double OwnNumber::times_that_at(double other_log_load, double exponent) const {
  const double more = exponent * (log_load - other_log_load);
  return std::isnan(more) ? 1 : std::exp(more);
}

ExponentRange likely_exponents(const std::vector<std::vector<OwnNumber>>& groups) {
  const LoadSlopes slopes(groups);
  if (slopes.is_empty()) return {};
  return {slopes.below(0.25), slopes.below(0.75)};
}

ExponentRange exponents_beside(const std::vector<std::vector<OwnNumber>>& groups, std::size_t trial) {
  constexpr double most = 1;
  constexpr std::size_t many = 60;  // trials: of more, one that is left out moves the quartiles little
  if (LoadSlopes(groups).is_empty()) return {};
  std::vector<std::size_t> others{trial};
  for (const std::vector<OwnNumber>& group : groups)
    for (const OwnNumber& own : group) others.push_back(own.trial);
  if (others.size() > many) others.resize(1);
  ExponentRange range{most, -most};
  for (const std::size_t other : others) {
    std::vector<std::vector<OwnNumber>> left = groups;
    for (std::vector<OwnNumber>& group : left)
      std::erase_if(group, [&](const OwnNumber& own) { return own.trial == trial || own.trial == other; });
    const LoadSlopes slopes(left);
    range.least = std::min(range.least, slopes.is_empty() ? -most : std::max(-most, slopes.below(0.25)));
    range.most = std::max(range.most, slopes.is_empty() ? most : std::min(most, slopes.below(0.75)));
  }
  return range;
}

std::optional<double> median_slope(const std::vector<std::vector<OwnNumber>>& groups) {
  const LoadSlopes slopes(groups);
  if (slopes.is_empty()) return std::nullopt;
  return slopes.below(0.5);
}

}  // namespace fingerpad
