#pragma once

#include <cstddef>
#include <vector>

#include "base/random_stream.hpp"

namespace fingerpad {

/// What a bootstrap draws as one: trials within each subject, or whole subjects.
enum class Blocks { trials, subjects };

/// How often each trial is drawn, with replacement.
/// @param subject_of  per trial
std::vector<int> drawn_times(const std::vector<int>& subject_of, Blocks blocks, RandomStream& random);

/// Mean and spread of a number over the draws that give it.
struct DrawSpread {
  double count = 0, mean = 0, squares = 0;
  void add(double value) {
    ++count;
    const double off = value - mean;
    mean += off / count;
    squares += off * (value - mean);
  }
};

/// How far a 95 % interval reaches to either side of an estimate: Student's t times the spread of the draws,
/// widened by sqrt(n/(n-1)) for the n blocks of a group that a draw holds less different than they are.
/// Half the blocks count as Student's degrees of freedom: they do not weigh alike.
/// @param blocks  that were drawn, of `groups` groups (of trials: subjects; of subjects: one)
/// @returns 0 where there are too few blocks to tell
double interval_reach(const DrawSpread& spread, double blocks, double groups);

}  // namespace fingerpad
