#pragma once

#include <span>
#include <string>

#include "trace/trace.hpp"
#include "trace/trace_column.hpp"

namespace fingerpad {

/// The header line of a trace with these columns as CSV, with its line end.
std::string csv_header(std::span<const TraceColumn> columns);

/// Appends one row with its line end: shortest numbers that read back the same, `nan` for none, the phase by
/// name.
void append_csv_row(std::string& out, std::span<const TraceColumn> columns, const TickRecord& record);

/// Reads a trace written as CSV. Throws Error (refused, `file:line`).
Trace read_csv_trace(const std::string& path);

}  // namespace fingerpad
