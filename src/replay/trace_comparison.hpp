#pragma once

#include <vector>

#include "replay/folder_comparison.hpp"
#include "trace/trace.hpp"

namespace fingerpad {

/// What differs between two traces, a change a column: at the times that both have.
/// @param tolerance  what a column may differ by, in its own unit
std::vector<JobChange> trace_changes(const Trace& a, const Trace& b, double tolerance);

/// 0 for equal numbers and two that are none; infinite where only one is none.
double distance_between(double a, double b) noexcept;

}  // namespace fingerpad
