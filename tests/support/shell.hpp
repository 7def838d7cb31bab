#pragma once

#include <filesystem>
#include <string>

namespace fingerpad::test {

/// How a shell command ended.
struct ShellResult {
  int exit_code = -1;
  std::string out, err;
};

/// Runs a shell command in a folder, with no standard input and no display; standard output and error are
/// kept apart.
ShellResult shell(const std::string& command, const std::filesystem::path& folder);

/// Runs the built program with these arguments (written as in a shell).
ShellResult fingerpad(const std::string& arguments, const std::filesystem::path& folder);

/// The bytes of a file; a failed expectation where it cannot be read.
std::string bytes_of(const std::filesystem::path& path);

}  // namespace fingerpad::test
