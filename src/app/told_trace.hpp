#pragma once

#include <string>

#include "trace/trace.hpp"

namespace fingerpad {

/// Warns that a trace ends early. @param words  early_end_words(); nothing is told of empty ones
void tell_early_end(const std::string& path, const std::string& words);

/// read_trace(), and a warning where the trace ends early. Throws Error (refused) where it has no row: there
/// is nothing to show of it.
Trace read_told_trace(const std::string& path, TraceContents contents);

}  // namespace fingerpad
