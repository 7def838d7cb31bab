#include "view/screenshot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "base/error.hpp"
#include "view/view_input.hpp"

namespace fingerpad {

namespace {

/// Neither nothing nor a standard stream.
bool is_named_file(const std::string& name) {
  return !name.empty() && name != "-";
}

/// Without a file's name, the title as far as it may be one.
std::string screenshot_stem(const ViewInput& input) {
  if (is_named_file(input.file)) return std::filesystem::path(input.file).stem().string();
  std::string stem = input.title.empty() ? "fingerpad" : input.title;
  std::replace(stem.begin(), stem.end(), '/', '-');
  return stem;
}

}  // namespace

std::string next_screenshot_name(const ViewInput& input) {
  namespace fs = std::filesystem;
  const fs::path folder =
      is_named_file(input.recording) ? fs::path(input.recording).parent_path() : fs::path();
  const std::string stem = screenshot_stem(input);
  constexpr int most = 9999;
  for (int number = 1; number <= most; ++number) {
    const fs::path path = folder / fmt::format("{}-view-{:03}.png", stem, number);
    std::error_code ignored;
    // A link that leads nowhere is somebody's file too.
    if (fs::symlink_status(path, ignored).type() == fs::file_type::not_found) return path.string();
  }
  throw Error(ErrorKind::usage, stem, fmt::format("has {} screenshots already: move some away", most));
}

}  // namespace fingerpad
