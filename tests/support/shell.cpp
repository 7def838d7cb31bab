#include "support/shell.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "support/paths.hpp"

namespace fingerpad::test {
namespace fs = std::filesystem;

std::string bytes_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  EXPECT_TRUE(file.good()) << path;
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

ShellResult shell(const std::string& command, const fs::path& folder) {
  // Tests and threads that run side by side may share a folder: the names are this call's own.
  static std::atomic<int> calls = 0;
  const std::string name = ".shell-" + std::to_string(getpid()) + "-" + std::to_string(++calls);
  const fs::path out = folder / (name + "-out"), err = folder / (name + "-err"), script = folder / name;
  std::ofstream(script) << "unset DISPLAY WAYLAND_DISPLAY\n" << command << "\n";
  const std::string call =
      "cd '" + folder.string() + "' && bash " + name + " >" + name + "-out 2>" + name + "-err </dev/null";
  const int status = std::system(call.c_str());
  ShellResult result;
  result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128;
  result.out = bytes_of(out);
  result.err = bytes_of(err);
  fs::remove(out);
  fs::remove(err);
  fs::remove(script);
  return result;
}

ShellResult fingerpad(const std::string& arguments, const fs::path& folder) {
  return shell("'" + program().string() + "' " + arguments, folder);
}

}  // namespace fingerpad::test
