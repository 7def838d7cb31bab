#pragma once

#include <string>
#include <vector>

#include "trace/trace.hpp"

namespace fingerpad {

/// Writes the touched parts, the finger's path and its contact points as one multi-block file (.vtm beside a
/// folder of its name, as vtkXMLMultiBlockDataWriter lays it out) that ParaView opens. Blocks: each part by
/// its mesh's name (a plane as a square about what was touched), "path", "contact points". Lengths are in
/// metres; the names of arrays say their unit.
///
/// The whole is there or nothing: the folder is written first, the .vtm last.
/// @returns  what of the geometry is missing or not as it was, a line each: a part that is neither in the
///           trace nor where its mesh was, and a mesh that has changed since
/// Throws Error as OutputFile does.
std::vector<std::string> export_blocks(const Trace& trace, const std::string& trace_path,
                                       const std::string& path);

}  // namespace fingerpad
