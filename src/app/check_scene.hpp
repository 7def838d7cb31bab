#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace fingerpad {

/// Looks at a scene's parts, finger and motion, of a set at every mesh and motion once, the motions with the
/// parts of the first job whose meshes can all be touched; tells them on standard output, or at the report's
/// end, and what is odd on standard error.
/// @returns whether nothing of it is refused. Throws Error (refused, input) where replay would before its
/// first job.
bool check_scene(const std::string& path, bool as_json, nlohmann::ordered_json& report);

}  // namespace fingerpad
