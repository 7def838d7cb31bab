#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace fingerpad {

/// Looks at a scene's parts, finger and motion; of a set at every mesh, every motion and every finger on the
/// parts that it is to touch, once, a motion with the first job that follows it and whose parts can all be
/// touched. Tells them on standard output, or at the report's end, and what is odd on standard error.
/// @returns whether nothing of it is refused. Throws Error (refused, input) where replay would before its
/// first job.
bool check_scene(const std::string& path, bool as_json, nlohmann::ordered_json& report);

}  // namespace fingerpad
