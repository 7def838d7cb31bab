#pragma once

#include <cstdint>
#include <string>

#include "trace/trace.hpp"
#include "trace/trace_writer.hpp"

namespace fingerpad {

/// Throws Error (fault) where the disk has no room for a trace of so many rows, before any is written: what
/// it takes at least, what there is, and which options write less.
/// @param path  of the trace; its folder is there
void refuse_full_disk(const std::string& path, TraceFormat format, const TraceInfo& info, std::uint64_t rows);

}  // namespace fingerpad
