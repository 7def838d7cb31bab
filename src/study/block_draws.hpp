#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
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

/// One block left out, as how often each trial counts then.
struct LeftOut {
  std::vector<int> times;
  int group = 0;     ///< the subject, or 0 of whole subjects
  double parts = 0;  ///< into which the group was parted
};

/// Leaves every block out in turn; of groups of more than a hundred trials a hundredth at a time.
/// @returns how many it was
std::size_t each_left_out(const std::vector<int>& subject_of, Blocks blocks,
                          const std::function<void(const LeftOut&)>& tell);

/// The jackknife's spread of a number, by what it is with a block left out (Efron and Stein 1981). A block on
/// which much of the number rests moves it more by its absence than it does in the draws of a bootstrap,
/// which keep it or its like: where few carry a number, as a bend or a slope, those are a fifth too narrow.
class LeftOutSpread {
 public:
  void add(const LeftOut& left_out, double value);
  /// Standard deviation; nothing where fewer were added than `wanted`.
  std::optional<double> deviation(std::size_t wanted) const;

 private:
  struct Group {
    DrawSpread values;
    double parts = 0;
  };
  std::map<int, Group> groups_;
  std::size_t added_ = 0;
};

/// Fewer blocks than these and one for each group tell no interval.
inline constexpr double least_freedom = 2;

/// How far a 95 % interval reaches to either side of an estimate: Student's t times the spread of the draws,
/// widened by sqrt(n/(n-1)) for the n blocks of a group that a draw holds less different than they are, or
/// that of the jackknife if it is more. Half the blocks count as Student's degrees of freedom: they do not
/// weigh alike.
/// @param left_out  the jackknife's deviation, if there is one
/// @param blocks    that were drawn, of `groups` groups (of trials: subjects; of subjects: one)
/// @returns 0 where there are too few blocks to tell
double interval_reach(const DrawSpread& spread, std::optional<double> left_out, double blocks, double groups);

}  // namespace fingerpad
