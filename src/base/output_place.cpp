#include "base/output_place.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>

#include "base/error.hpp"
#include "base/path_words.hpp"

namespace fingerpad {
namespace {

Error uncreatable(const std::string& path, const std::string& why) {
  return {ErrorKind::usage, path, "cannot be created: " + why};
}

void refuse_folder(const std::string& path, const std::string& folder) {
  struct stat status {};
  if (stat(folder.c_str(), &status) != 0) {
    const int problem = errno;
    throw uncreatable(path, path_words(problem == ENOENT ? path : folder, problem));
  }
  if (!S_ISDIR(status.st_mode)) throw uncreatable(path, fmt::format("{} is a file, not a folder", folder));
  if (faccessat(AT_FDCWD, folder.c_str(), W_OK | X_OK, AT_EACCESS) != 0) {
    const int problem = errno;
    throw uncreatable(path,
                      problem == EROFS
                          ? fmt::format("the folder {} is on a disk that is read only", folder)
                          : fmt::format("permission denied: you may not write into the folder {}", folder));
  }
}

/// What is to be made for a folder to be there, innermost first.
std::vector<std::filesystem::path> missing_folders(std::filesystem::path path) {
  if (!path.has_filename()) path = path.parent_path();  // "out/"
  std::vector<std::filesystem::path> missing;
  std::error_code ignored;
  while (!path.empty() && !std::filesystem::exists(std::filesystem::symlink_status(path, ignored))) {
    if (path.filename() != ".") missing.push_back(path);  // of "new/./out" two
    path = path.parent_path();
  }
  return missing;
}

}  // namespace

std::vector<std::filesystem::path> make_folder(const std::string& path) {
  std::vector<std::filesystem::path> missing = missing_folders(path);
  std::error_code failure;
  std::filesystem::create_directories(path, failure);
  if (!failure) return missing;
  remove_empty(missing);
  throw Error(output_fault(failure.value()), path,
              "cannot be made: " + unmade_words(path, failure.value(), Made::folder));
}

void remove_empty(const std::vector<std::filesystem::path>& folders) noexcept {
  for (const std::filesystem::path& folder : folders)
    rmdir(folder.c_str());  // fails where something is in it
}

void refuse_unwritable(const std::string& path) {
  if (path == "-") return;
  if (path.empty()) throw Error(ErrorKind::usage, "the output", "its name is empty: name a file");
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
