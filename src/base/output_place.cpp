#include "base/output_place.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "base/error.hpp"
#include "base/path_words.hpp"

namespace fingerpad {
namespace {

Error uncreatable(const std::string& path, const std::string& why) {
  return {ErrorKind::fault, path, "cannot be created: " + why};
}

void refuse_folder(const std::string& path, const std::string& folder) {
  struct stat status {};
  if (stat(folder.c_str(), &status) != 0) {
    const int problem = errno;
    const std::string why = problem == ENOENT
                                ? fmt::format("{}: {}", std::strerror(problem), path_words(path, problem))
                                : path_words(folder, problem);
    throw uncreatable(path, why);
  }
  if (!S_ISDIR(status.st_mode)) throw uncreatable(path, fmt::format("{} is a file, not a folder", folder));
  if (faccessat(AT_FDCWD, folder.c_str(), W_OK | X_OK, AT_EACCESS) != 0) {
    throw uncreatable(path,
                      fmt::format("{}: you may not write into the folder {}", std::strerror(errno), folder));
  }
}

}  // namespace

void refuse_unwritable(const std::string& path) {
  if (path == "-") return;
  if (path.empty()) throw uncreatable("the output", "its name is empty");
  struct stat status {};
  if (stat(path.c_str(), &status) == 0) {
    if (S_ISDIR(status.st_mode)) throw uncreatable(path, "is a folder: name a file in it");
    if (!S_ISREG(status.st_mode)) return;
  } else if (errno != ENOENT) {
    throw uncreatable(path, path_words(path, errno));
  }
  // A file is written beside its place and renamed when it is whole: the folder must allow it.
  const std::string folder = std::filesystem::path(path).parent_path().string();
  refuse_folder(path, folder.empty() ? "." : folder);
}

}  // namespace fingerpad
