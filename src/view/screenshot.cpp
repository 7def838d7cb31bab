#include "view/screenshot.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "base/error.hpp"

namespace fingerpad {

std::string next_screenshot_name(const std::string& file, const std::string& title) {
  namespace fs = std::filesystem;
  const bool named = !file.empty() && file != "-";
  const fs::path folder = named ? fs::path(file).parent_path() : fs::path();
  const std::string stem = named ? fs::path(file).stem().string() : title.empty() ? "fingerpad" : title;
  constexpr int most = 9999;
  for (int number = 1; number <= most; ++number) {
    const fs::path path = folder / fmt::format("{}-view-{:03}.png", stem, number);
    std::error_code ignored;
    // A link that leads nowhere is somebody's file too.
    if (fs::symlink_status(path, ignored).type() == fs::file_type::not_found) return path.string();
  }
  throw Error(ErrorKind::usage, file, fmt::format("has {} screenshots already: move some away", most));
}

}  // namespace fingerpad
