#include "base/file_identity.hpp"

#include <fmt/format.h>
#include <sys/stat.h>

#include "base/error.hpp"

namespace fingerpad {

std::optional<std::string> file_identity(const std::string& path) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
  return fmt::format("{}:{}", status.st_dev, status.st_ino);
}

void refuse_overwriting(const std::string& out, const std::vector<std::string>& inputs) {
  for (const std::string& written : {out, out + ".part"}) {
    const auto identity = file_identity(written);
    if (!identity) continue;
    for (const std::string& input : inputs) {
      if (file_identity(input) != identity) continue;
      throw refused(written, input == written
                                 ? "is an input of this command and would be overwritten; give another --out"
                                 : fmt::format("is the file {}, an input of this command, and would be "
                                               "overwritten; give another output",
                                               input));
    }
  }
}

}  // namespace fingerpad
