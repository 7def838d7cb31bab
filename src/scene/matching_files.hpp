#pragma once

#include <string>
#include <vector>

namespace fingerpad {

/// The paths that match a pattern, sorted by name; relative to the scene's folder unless the pattern is
/// absolute.
std::vector<std::string> matching_files(const std::string& pattern, const std::string& scene_path);

}  // namespace fingerpad
