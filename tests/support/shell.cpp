#include "support/shell.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>

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
  const fs::path out = folder / ".shell-out", err = folder / ".shell-err", script = folder / ".shell-script";
  std::ofstream(script) << "unset DISPLAY WAYLAND_DISPLAY\n" << command << "\n";
  const std::string call =
      "cd '" + folder.string() + "' && bash .shell-script >.shell-out 2>.shell-err </dev/null";
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
