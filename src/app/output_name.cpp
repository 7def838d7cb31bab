#include "app/output_name.hpp"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include "app/standard_streams.hpp"
#include "base/error.hpp"

namespace fingerpad {
namespace {

bool is_standard_output(const std::string& path) {
  if (path == "-") return true;
  struct stat named {
  }, output{};
  return stat(path.c_str(), &named) == 0 && fstat(STDOUT_FILENO, &output) == 0 &&
         named.st_dev == output.st_dev && named.st_ino == output.st_ino;
}

/// ".png", ".png or .svg", ".a, .b or .c".
std::string any_of_these(std::initializer_list<std::string_view> endings) {
  std::string text;
  std::size_t left = endings.size();
  for (const std::string_view ending : endings) {
    text += ending;
    if (--left > 0) text += left > 1 ? ", " : " or ";
  }
  return text;
}

}  // namespace

CLI::Option* refuse_empty(CLI::Option* option, const char* takes) {
  option->type_name(takes);
  const auto fault = [](const std::string& text) {
    return text.empty() ? std::string("is empty: give a name") : std::string();
  };
  return option->check(CLI::Validator(fault, ""));
}

void refuse_other_endings(const std::string& path, std::string_view who,
                          std::initializer_list<std::string_view> endings) {
  const bool known = std::any_of(endings.begin(), endings.end(),
                                 [&path](std::string_view ending) { return path.ends_with(ending); });
  if (!known)
    throw Error(ErrorKind::usage, path, fmt::format("{} writes {} files", who, any_of_these(endings)));
}

void refuse_unfit_name(const std::string& path, std::string_view who,
                       std::initializer_list<std::string_view> endings) {
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  const bool is_stream = std::filesystem::exists(status) && !std::filesystem::is_regular_file(status);
  if (path == "-" || is_stream || !std::filesystem::path(path).has_extension()) return;
  refuse_other_endings(path, who, endings);
}

void add_quiet_flag(CLI::App& command, bool& quiet) {
  command.add_flag("--quiet", quiet, "No closing line; errors and warnings are still told");
}

void tell_written(bool quiet, const std::string& path, const std::string& what) {
  if (!quiet && !is_standard_output(path)) print_out("wrote {} ({})\n", path, what);
}

}  // namespace fingerpad
