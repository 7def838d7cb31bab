#include "motion/joined_clocks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "base/error.hpp"
#include "base/number_text.hpp"

namespace fingerpad {
namespace {

constexpr double longest_steps = 2;  // of the slower clock; a longer one is a gap

double median_clock_step_s(const ClockedValues& values, const std::string& where) {
  if (values.t_s.size() < 2)
    throw refused(where, fmt::format("the {} have {} samples; it takes two", values.what, values.t_s.size()));
  std::vector<double> steps;
  steps.reserve(values.t_s.size() - 1);
  for (std::size_t i = 1; i < values.t_s.size(); ++i) {
    steps.push_back(values.t_s[i] - values.t_s[i - 1]);
    if (!(steps.back() > 0))
      throw refused(where, fmt::format("the {}: time {} s does not come after {} s", values.what,
                                       values.t_s[i], values.t_s[i - 1]));
  }
  const auto middle = steps.begin() + static_cast<long>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

/// The slower's values at the times of the quicker, and which of these have one.
struct TakenAcross {
  std::vector<Eigen::Index> times;
  Eigen::MatrixXd values;
  std::size_t outside = 0, in_gaps = 0;
};

TakenAcross taken_across(const ClockedValues& slow, double slow_step_s, const ClockedValues& quick) {
  TakenAcross taken;
  taken.values.resize(slow.values.rows(), static_cast<Eigen::Index>(quick.t_s.size()));
  std::size_t right = 1;
  for (std::size_t i = 0; i < quick.t_s.size(); ++i) {
    const double t_s = quick.t_s[i];
    if (t_s < slow.t_s.front() || t_s > slow.t_s.back()) {
      ++taken.outside;
      continue;
    }
    while (right + 1 < slow.t_s.size() && slow.t_s[right] < t_s) ++right;
    const double span_s = slow.t_s[right] - slow.t_s[right - 1];
    if (span_s > longest_steps * slow_step_s) {
      ++taken.in_gaps;
      continue;
    }
    const double share = (t_s - slow.t_s[right - 1]) / span_s;
    const auto column = static_cast<Eigen::Index>(right);
    taken.values.col(static_cast<Eigen::Index>(taken.times.size())) =
        (1 - share) * slow.values.col(column - 1) + share * slow.values.col(column);
    taken.times.push_back(static_cast<Eigen::Index>(i));
  }
  taken.values.conservativeResize(Eigen::NoChange, static_cast<Eigen::Index>(taken.times.size()));
  return taken;
}

}  // namespace

JoinedClocks join_clocks(const ClockedValues& first, const ClockedValues& second, const std::string& where) {
  const double first_step_s = median_clock_step_s(first, where);
  const double second_step_s = median_clock_step_s(second, where);
  const bool first_is_slow = first_step_s > second_step_s;
  const ClockedValues &slow = first_is_slow ? first : second, &quick = first_is_slow ? second : first;
  TakenAcross taken = taken_across(slow, std::max(first_step_s, second_step_s), quick);
  if (taken.times.size() < 2) {
    throw refused(
        where,
        fmt::format("the {} from {} to {} s and the {} from {} to {} s have "
                    "no time in common: their clocks must count from the same moment",
                    first.what, rounded_text(first.t_s.front(), 6), rounded_text(first.t_s.back(), 6),
                    second.what, rounded_text(second.t_s.front(), 6), rounded_text(second.t_s.back(), 6)));
  }
  JoinedClocks joined;
  Eigen::MatrixXd kept(quick.values.rows(), taken.values.cols());
  for (std::size_t i = 0; i < taken.times.size(); ++i) {
    joined.t_s.push_back(quick.t_s[static_cast<std::size_t>(taken.times[i])]);
    kept.col(static_cast<Eigen::Index>(i)) = quick.values.col(taken.times[i]);
  }
  joined.note = fmt::format(
      "{}, about {:.0f} Hz, taken straight between their samples at the {} {}, about "
      "{:.0f} Hz; {} of these left out: {} outside of the former, {} in gaps of theirs",
      slow.what, 1 / std::max(first_step_s, second_step_s), quick.t_s.size(), quick.what,
      1 / std::min(first_step_s, second_step_s), taken.outside + taken.in_gaps, taken.outside, taken.in_gaps);
  joined.first.swap(first_is_slow ? taken.values : kept);
  joined.second.swap(first_is_slow ? kept : taken.values);
  return joined;
}

Eigen::MatrixXd values_at(const ClockedValues& values, const std::vector<double>& t_s,
                          const std::string& where) {
  const ClockedValues times{"", t_s, Eigen::MatrixXd(0, static_cast<Eigen::Index>(t_s.size()))};
  const TakenAcross taken = taken_across(values, median_clock_step_s(values, where), times);
  Eigen::MatrixXd found = Eigen::MatrixXd::Constant(values.values.rows(), times.values.cols(),
                                                    std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < taken.times.size(); ++i)
    found.col(taken.times[i]) = taken.values.col(static_cast<Eigen::Index>(i));
  return found;
}

}  // namespace fingerpad
