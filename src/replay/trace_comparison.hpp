#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "trace/trace.hpp"

namespace fingerpad {

/// One thing in which a job differs.
struct JobChange {
  std::string column;  ///< of the trace or the summary; empty: the job itself, as where one folder lacks it
  std::string words;   ///< what is told of it, without the job's name
  double most = 0;     ///< the greatest difference; infinite from a number to none, nan without a column
  std::string_view unit;
  double at_s = 0;  ///< where that is; nan of a summary's
};

/// Of the job or the trace itself, not of a column.
JobChange whole_change(std::string words);

/// Whether a column says where a motion or a hand put the finger, not what was felt there.
bool is_of_the_way(std::string_view column) noexcept;

/// What differs between two traces, a change a column: at the times that both have. Where the finger went
/// another way, that is said before, since what was felt is then another touch's.
/// @param tolerance           what a column may differ by, in its own unit
/// @param are_of_two_formats  columns that HDF5 alone has are passed over
std::vector<JobChange> trace_changes(const Trace& a, const Trace& b, double tolerance,
                                     bool are_of_two_formats);

/// 0 for equal numbers and two that are none; infinite where only one is none.
double distance_between(double a, double b) noexcept;

}  // namespace fingerpad
