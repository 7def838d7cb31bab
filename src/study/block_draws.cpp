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

double interval_reach(const DrawSpread& spread, double blocks, double groups) {
  constexpr double least_freedom = 2;
  const double freedom = blocks - groups;
  // Blocks do not weigh alike, so that fewer of them tell the spread: half.
  const double telling = std::max(least_freedom, blocks / 2 - groups);
  if (freedom < least_freedom || spread.count < 2) return 0;
  const double t = telling < 3 ? 4.303 : student_t(telling);
  return t * std::sqrt(blocks / freedom) * std::sqrt(spread.squares / (spread.count - 1));
}

}  // namespace fingerpad
