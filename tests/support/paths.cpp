#include "support/paths.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <system_error>

#include "support/effort.hpp"

namespace fingerpad::test {
namespace fs = std::filesystem;

fs::path source_dir() {
  return FINGERPAD_SOURCE_DIR;
}

fs::path program() {
  return FINGERPAD_BINARY;
}

std::optional<fs::path> real_data() {
  const char* named = std::getenv("FINGERPAD_TEST_DATA");
  const fs::path folder = named != nullptr ? fs::path(named) : source_dir() / ".." / "shared" / "data";
  if (!fs::is_directory(folder)) return std::nullopt;
  return fs::canonical(folder);
}

std::vector<fs::path> real_files(const std::string& folder, const std::vector<std::string>& endings) {
  std::vector<fs::path> found;
  const auto data = real_data();
  if (!data || !fs::is_directory(*data / folder)) return found;
  for (const auto& entry : fs::directory_iterator(*data / folder)) {
    if (std::find(endings.begin(), endings.end(), entry.path().extension().string()) != endings.end()) {
      found.push_back(entry.path());
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<fs::path> real_parts() {
  std::vector<fs::path> parts = real_files("parts", {".stl", ".obj", ".ply", ".off"});
  int number = 0;
  std::erase_if(parts, [&number](const fs::path&) { return number++ % (samples(40) < 40 ? 6 : 1) != 0; });
  return parts;
}

namespace {

/// This process's own folder for what its tests write. Goes with the process, unless one of them failed: then
/// it is there to be looked at.
struct Scratch {
  pid_t owner = getpid();
  fs::path folder = fs::temp_directory_path() / ("fingerpad-test-" + std::to_string(owner));

  Scratch() = default;
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  ~Scratch() {
    if (getpid() != owner || testing::UnitTest::GetInstance()->Failed()) return;
    std::error_code ignored;
    fs::remove_all(folder, ignored);
  }
};

}  // namespace

fs::path scratch_dir() {
  static const Scratch scratch;
  const auto* info = testing::UnitTest::GetInstance()->current_test_info();
  std::string name = std::string(info->test_suite_name()) + "." + info->name();
  std::replace(name.begin(), name.end(), '/', '_');
  const fs::path folder = scratch.folder / name;
  fs::remove_all(folder);
  fs::create_directories(folder);
  return folder;
}

}  // namespace fingerpad::test
