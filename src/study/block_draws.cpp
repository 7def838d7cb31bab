#include "study/block_draws.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace fingerpad {
namespace {

/// 97.5 % quantile of Student's t, by Cornish and Fisher's expansion (Abramowitz and Stegun 26.7.5): within 1
/// % from 3 degrees of freedom up.
double student_t(double freedom) {
  const double z = 1.959963985, z3 = z * z * z, z5 = z3 * z * z, z7 = z5 * z * z;
  return z + (z3 + z) / (4 * freedom) + (5 * z5 + 16 * z3 + 3 * z) / (96 * freedom * freedom) +
         (3 * z7 + 19 * z5 + 17 * z3 - 15 * z) / (384 * freedom * freedom * freedom);
}

}  // namespace

std::vector<int> drawn_times(const std::vector<int>& subject_of, Blocks blocks, RandomStream& random) {
  std::map<int, std::vector<std::size_t>> subjects;
  for (std::size_t i = 0; i < subject_of.size(); ++i) subjects[subject_of[i]].push_back(i);
  const auto pick = [&](std::size_t count) {
    return static_cast<std::size_t>(random.uniform() * static_cast<double>(count));
  };
  std::vector<int> times(subject_of.size(), 0);
  for (const auto& [subject, own] : subjects) {
    if (blocks == Blocks::subjects) {
      for (const std::size_t i :
           std::next(subjects.begin(), static_cast<std::ptrdiff_t>(pick(subjects.size())))->second)
        ++times[i];
      continue;
    }
    for (std::size_t k = 0; k < own.size(); ++k) ++times[own[pick(own.size())]];
  }
  return times;
}

std::size_t each_left_out(const std::vector<int>& subject_of, Blocks blocks,
                          const std::function<void(const LeftOut&)>& tell) {
  constexpr std::size_t most_parts = 100;
  std::map<int, std::vector<std::size_t>> subjects;
  for (std::size_t i = 0; i < subject_of.size(); ++i) subjects[subject_of[i]].push_back(i);
  LeftOut left{std::vector<int>(subject_of.size(), 1)};
  std::size_t told = 0;
  for (const auto& [subject, own] : subjects) {
    const bool is_whole = blocks == Blocks::subjects;
    const std::size_t parts = is_whole ? 1 : std::min(most_parts, own.size());
    left.group = is_whole ? 0 : subject;
    left.parts = static_cast<double>(is_whole ? subjects.size() : parts);
    for (std::size_t part = 0; part < parts; ++part, ++told) {
      for (std::size_t k = part; k < own.size(); k += parts) left.times[own[k]] = 0;
      tell(left);
      for (std::size_t k = part; k < own.size(); k += parts) left.times[own[k]] = 1;
    }
  }
  return told;
}

void LeftOutSpread::add(const LeftOut& left_out, double value) {
  Group& group = groups_[left_out.group];
  group.values.add(value);
  group.parts = left_out.parts;
  ++added_;
}

std::optional<double> LeftOutSpread::deviation(std::size_t wanted) const {
  if (added_ < wanted) return std::nullopt;
  double variance = 0;
  for (const auto& [name, group] : groups_)
    variance += (group.parts - 1) / group.parts * group.values.squares;
  return std::sqrt(variance);
}

double interval_reach(const DrawSpread& spread, std::optional<double> left_out, double blocks,
                      double groups) {
  const double freedom = blocks - groups;
  // Blocks do not weigh alike, so that fewer of them tell the spread: half.
  const double telling = std::max(least_freedom, blocks / 2 - groups);
  if (freedom < least_freedom || spread.count < 2) return 0;
  const double t = telling < 3 ? 4.303 : student_t(telling);
  return t * std::max(std::sqrt(blocks / freedom) * std::sqrt(spread.squares / (spread.count - 1)),
                      left_out.value_or(0));
}

}  // namespace fingerpad
