#pragma once

#include <span>
#include <string>

#include "study/judged_runs.hpp"

namespace fingerpad {

/// What becomes of `auto`'s word on a case.
enum class JudgedWord {
  kept,      ///< it promised the scene's force_tolerance, and kept it
  said,      ///< it said that this cannot be kept; that is so, and what it said instead was kept
  needless,  ///< it said so, and yet it was kept
  broken
};
std::string to_string(JudgedWord word);

/// One case under every pair of method and normals, over its own motion and over the promise's trials; those
/// that the case leaves unjudged have infinite errors.
struct JudgedRow {
  std::string name, said;
  double triangles = 0, radius_m = 0, tolerance = 0;
  double promised = 0;                    ///< force_tolerance, or what it said could be kept in its place;
                                          ///< infinity: nothing
  bool is_exact = false;                  ///< whether the surface is known
  std::size_t chosen = 0;                 ///< of contact_variants()
  std::vector<double> error_99, tick_ns;  ///< by variant: on 99 % of the motion's ticks no larger than this
  std::vector<double> trial_99;           ///< by variant: the largest such error of the promise's trials; of
                                          ///< those not chosen no more is tried once it is above tolerance
  std::vector<double> cost;               ///< by variant, as the committed table has it
  /// By variant, in the motion and in those trials; the last, the most complete, tells how many are the
  /// ways': a finger that is dragged through a part's inside.
  std::vector<long> pop_throughs, trial_pop_throughs;
  long ticks = 0;  ///< of the motion, on which anything is felt

  /// Whether the finger pops through with it where it does not with the most complete.
  bool pops(std::size_t variant, bool in_trials_too) const;
  /// By the motion and the trials.
  JudgedWord word() const;
  /// By the motion alone, which need not meet what the part has.
  JudgedWord word_of_motion() const;
  /// The variant of the least `price` of those that keep the tolerance in the motion and, where `of_promise`,
  /// in the trials; contact_variants().size(): none.
  std::size_t cheapest(const std::vector<double>& price, bool of_promise) const;
  /// What the chosen one costs in units of that; nan where there is none.
  double price_ratio(const std::vector<double>& price, bool of_promise) const;
};

/// What became of auto's word over many cases.
struct JudgedCount {
  int cases = 0, kept = 0, said = 0, needless = 0, broken = 0;
  int near_cheapest = 0;  ///< of those kept: cost at most 1.2 times the cheapest that keeps the promise
};

/// @param of_promise  by the motions and the trials; else by the motions alone
JudgedCount count_words(std::span<const JudgedRow> rows, bool of_promise);

/// @param turns  JudgedRun's
JudgedRow judged(const JudgedCase& one, int turns);

}  // namespace fingerpad
