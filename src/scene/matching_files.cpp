#include "scene/matching_files.hpp"

#include <glob.h>

#include <algorithm>
#include <filesystem>

namespace fingerpad {

namespace fs = std::filesystem;

std::vector<std::string> matching_files(const std::string& pattern, const std::string& scene_path) {
  std::string folder;
  if (!fs::path(pattern).is_absolute()) folder = fs::path(scene_path).parent_path().string();
  if (!folder.empty() && folder.back() != '/') folder += '/';
  std::string escaped;
  for (const char c : folder) {
    if (c == '*' || c == '?' || c == '[' || c == ']' || c == '\\') escaped += '\\';
    escaped += c;
  }
  std::vector<std::string> files;
  glob_t found{};
  if (glob((escaped + pattern).c_str(), GLOB_NOSORT | GLOB_MARK, nullptr, &found) == 0) {
    for (std::size_t i = 0; i < found.gl_pathc; ++i) {
      const std::string file = found.gl_pathv[i];
      if (file.back() != '/' && file.starts_with(folder)) files.push_back(file.substr(folder.size()));
    }
  }
  globfree(&found);
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace fingerpad
