#pragma once

#include <string>
#include <vector>

#include "touch/world.hpp"
#include "trace/trace.hpp"

namespace fingerpad {

/// The surfaces that a trace's finger went over, as far as they can still be had.
struct RecordedParts {
  std::vector<Surface> surfaces;     ///< without trees; parts, then planes
  std::vector<std::string> missing;  ///< what is not there, or not as it was, a line each
};

/// The surfaces that a trace holds; of one that holds too large a part, those that its scene names, from
/// their files.
/// @param path  of the trace, where relative paths of its scene start
RecordedParts recorded_parts(const Trace& trace, const std::string& path);

}  // namespace fingerpad
