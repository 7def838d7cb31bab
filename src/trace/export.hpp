#pragma once

#include <string>

#include "trace/trace.hpp"

namespace fingerpad {

/// Writes a trace as CSV, byte for byte as replay --format csv would have. Throws Error as OutputFile does.
void export_csv(const Trace& trace, const std::string& path);

/// Writes the finger path as VTP (XML PolyData, a polyline with every column as point data, strings excluded)
/// that ParaView reads; non-finite positions never occur in a trace's x, y, z. Needs no VTK. Throws Error as
/// OutputFile does.
void export_vtp(const Trace& trace, const std::string& path);

}  // namespace fingerpad
