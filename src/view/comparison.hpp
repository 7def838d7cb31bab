#pragma once

#include <string>
#include <vector>

#include "view/compared_run.hpp"
#include "view/friction_sense.hpp"

namespace fingerpad {

/// What one run has of a quantity beyond another, where both have it.
struct Residual {
  std::size_t run = 0;  ///< index of the other; the first is what it is compared with
  std::string column, unit;
  std::vector<double> x, values;  ///< other less first
  std::size_t ticks = 0;          ///< at which both have a number
  double rms = 0;                 ///< over these; nan of fewer than two
};

/// Runs laid over one another.
struct Comparison {
  std::vector<ComparedRun> runs;
  std::vector<std::string> columns;  ///< drawn, in order
  std::vector<Residual> residuals;   ///< by column, then by run
  std::vector<std::string> notes;    ///< at which ticks they were compared, and what was interpolated
  FrictionSense friction;            ///< of all runs, where friction is drawn
};

/// Compares runs with the first. Two runs are compared where both are there, at the ticks of the one that has
/// fewer; the other is interpolated linearly between its own.
/// @param columns  by name; empty: normal force, friction and its coefficient where all have them; of one run
///                 that has no more than six, all; else the forces and the coefficient that all have, or else
///                 whatever they all have, at most six
/// Throws Error (refused) for no common column, a column that one lacks, or two that have no time in common.
Comparison compare_runs(std::vector<ComparedRun> runs, const std::vector<std::string>& columns, Over over);

/// A panel of each column, and below it one of what is left.
Chart comparison_chart(const Comparison& comparison, Over over);

/// "fn_n: RMS 0.0123 N, b less a, 1000 ticks", a line each; of one tick alone what is left there.
std::vector<std::string> residual_words(const Comparison& comparison);

}  // namespace fingerpad
