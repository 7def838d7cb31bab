#include "base/near_file.hpp"

#include <algorithm>
#include <cctype>
#include <string>
#include <vector>

#include "base/nearest_word.hpp"

namespace fingerpad {
namespace {

/// A word without its digits: files of a series differ in these alone, and which of them was meant is not
/// told.
std::string without_digits(std::string word) {
  std::erase_if(word, [](unsigned char c) { return std::isdigit(c) != 0; });
  return word;
}

}  // namespace

std::filesystem::path near_file(const std::filesystem::path& path) {
  namespace fs = std::filesystem;
  constexpr int most_entries = 1000;
  const fs::path folder = path.parent_path(), extension = path.extension();
  const std::string asked = path.stem().string();
  if (asked.size() < 2) return {};
  std::vector<std::string> names;
  std::error_code ignored;
  fs::directory_iterator at(folder.empty() ? "." : folder, ignored);
  for (int count = 0; at != fs::directory_iterator(); at.increment(ignored)) {
    if (++count > most_entries) return {};
    const std::string name = at->path().stem().string();
    if (at->path().extension() == extension && at->is_regular_file(ignored) &&
        without_digits(name) != without_digits(asked))
      names.push_back(name);
  }
  std::sort(names.begin(), names.end());  // of two that are equally near, the same one everywhere
  const std::string near = nearest_word(asked, names);
  return near.empty() ? fs::path() : folder / fs::path(near).concat(extension.string());
}

}  // namespace fingerpad
