#pragma once

#include <string>

#include "trace/handover.hpp"
#include "trace/trace.hpp"

/// An HDF5 trace is read by two: a child process opens the file, which may be forged, and tells what stands
/// in it; the parent hears that, checks it and makes the trace, and never opens the file with HDF5.
namespace fingerpad {

/// Throws Error (refused) for what is no trace, or points at anything outside itself.
void tell_trace(const std::string& path, TraceContents contents, Teller& tell);

/// Throws Error (refused) for values that no run writes, and what Hearer throws.
/// @param path  for messages alone
Trace hear_trace(const std::string& path, TraceContents contents, Hearer& hear);

}  // namespace fingerpad
