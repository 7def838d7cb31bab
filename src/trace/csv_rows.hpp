#pragma once

#include <span>
#include <string>

#include "trace/trace.hpp"
#include "trace/trace_column.hpp"

namespace fingerpad {

/// The header line of a trace with these columns as CSV, with its line end.
/// @param every  TraceInfo::every, which a last column tells where that is not 1
std::string csv_header(std::span<const TraceColumn> columns, std::uint64_t every = 1);

/// Appends one row with its line end: shortest numbers that read back the same, `nan` for none, the phase by
/// name.
void append_csv_row(std::string& out, std::span<const TraceColumn> columns, const TickRecord& record,
                    std::uint64_t every = 1);

/// Reads a trace written as CSV. Throws Error (refused, `file:line`).
Trace read_csv_trace(const std::string& path);

}  // namespace fingerpad
