#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "trace/trace_writer.hpp"

namespace fingerpad {

/// As TraceWriter::create, of an HDF5 trace.
std::unique_ptr<TraceWriter> create_hdf5_writer(const std::string& path, const TraceInfo& info,
                                                const World& world, std::uint64_t rows_to_come);

}  // namespace fingerpad
