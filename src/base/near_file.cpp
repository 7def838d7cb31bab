#include "base/near_file.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "base/nearest_word.hpp"

namespace fingerpad {

std::filesystem::path near_file(const std::filesystem::path& path) {
  namespace fs = std::filesystem;
  constexpr std::size_t most_names = 10000;
  std::vector<std::string> names;
  std::error_code ignored;
  const fs::path folder = path.parent_path(), extension = path.extension();
  fs::directory_iterator at(folder.empty() ? "." : folder, ignored);
  for (; at != fs::directory_iterator() && names.size() < most_names; at.increment(ignored)) {
    if (at->path().extension() == extension) names.push_back(at->path().stem().string());
  }
  std::sort(names.begin(), names.end());  // of two that are equally near, the same one everywhere
  const std::string near = nearest_word(path.stem().string(), names);
  return near.empty() ? fs::path() : folder / fs::path(near).concat(extension.string());
}

}  // namespace fingerpad
