#include "base/path_words.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <string_view>

#include "base/near_file.hpp"

namespace fingerpad {
namespace {

namespace fs = std::filesystem;

/// The longest beginning of a path that is there; empty if none is.
fs::path nearest_there(fs::path path) {
  std::error_code ignored;
  while (!path.empty() && !fs::exists(path, ignored)) {
    const fs::path above = path.parent_path();
    if (above == path) return {};
    path = above;
  }
  return path;
}

/// Of a path whose folder is not there: which one is, and which one may be meant. What is to be written there
/// need not be there.
std::string missing_folder_words(const fs::path& path) {
  std::error_code ignored;
  const fs::path folder = path.parent_path(), there = nearest_there(folder), near = near_folder(folder);
  std::string words = fmt::format("its folder {} is not there", folder.string());
  if (!there.empty()) words += fmt::format(" (only {} is)", there.string());
  if (near.empty()) return words;
  const fs::path moved = near / path.filename();
  if (fs::exists(moved, ignored)) return words + fmt::format("; did you mean {}?", moved.string());
  return words + fmt::format("; did you mean the folder {}?", near.string());
}

/// @param what  "file", "folder"
std::string missing_words(const fs::path& path, const char* what) {
  std::error_code ignored;
  if (fs::is_symlink(fs::symlink_status(path, ignored))) {
    return fmt::format("is a link to {}, which is not there", fs::read_symlink(path, ignored).string());
  }
  const fs::path folder = path.parent_path();
  if (!folder.empty() && !fs::exists(folder, ignored))
    return fmt::format("there is no such {}: {}", what, missing_folder_words(path));
  const fs::path part = path.string() + ".part";
  if (fs::is_regular_file(part, ignored))
    return fmt::format(
        "there is no such {}; of a recording by that name there is {}, cut short or still being written",
        what, part.string());
  const fs::path near = std::string_view(what) == "file" ? near_file(path) : near_folder(path);
  return fmt::format("there is no such {}{}", what,
                     near.empty() ? "" : fmt::format("; did you mean {}?", near.string()));
}

std::string not_a_folder_words(const fs::path& path) {
  std::error_code ignored;
  if (fs::exists(path, ignored)) return "is a file, not a folder";
  const fs::path there = nearest_there(path.parent_path());
  if (fs::is_directory(there, ignored)) return "a link on the way leads through a file, not a folder";
  return fmt::format("{} is a file, not a folder", there.string());
}

std::string forbidden_words(const fs::path& path) {
  // Of a path to be made no folder may be there but the first.
  fs::path folder = nearest_there(path.parent_path());
  if (folder.empty()) folder = ".";
  if (faccessat(AT_FDCWD, folder.c_str(), X_OK, AT_EACCESS) != 0)
    return fmt::format("permission denied: you may not look into its folder {}", folder.string());
  std::error_code ignored;
  if (!fs::exists(path, ignored) && faccessat(AT_FDCWD, folder.c_str(), W_OK, AT_EACCESS) != 0)
    return fmt::format("permission denied: you may not write into the folder {}", folder.string());
  return "permission denied: you have no right to it (chmod gives it)";
}

}  // namespace

std::string path_words(const std::string& path, int problem) {
  switch (problem) {
    case ENOENT:
      return missing_words(path, "file");
    case EACCES:
    case EPERM:
      return forbidden_words(path);
    case ELOOP:
      return "is a link that leads back to itself: point it at a file";
    case ENOTDIR:
      return not_a_folder_words(path);
    case ENAMETOOLONG:
      return "the name is longer than the file system takes";
    case EISDIR:
      return "is a folder";
    default:
      return std::strerror(problem);
  }
}

std::string folder_words(const std::string& path, int problem) {
  std::string name = path;
  while (name.size() > 1 && name.back() == '/') name.pop_back();
  return problem == ENOENT ? missing_words(name, "folder") : path_words(name, problem);
}

std::string unmade_words(const std::string& path, int problem, Made made) {
  const bool is_folder = made == Made::folder;
  const fs::path named(path), place = named.has_filename() ? named : named.parent_path();
  fs::path folder = is_folder ? nearest_there(place.parent_path()) : place.parent_path();
  if (folder.empty()) folder = ".";
  std::error_code ignored;
  const bool is_new = !fs::exists(fs::symlink_status(place, ignored));
  const bool is_allowed =
      fs::is_directory(folder, ignored) && faccessat(AT_FDCWD, folder.c_str(), W_OK | X_OK, AT_EACCESS) == 0;
  // The right to a file may be wanting though its folder's is there: of a file beside it, which is renamed.
  const bool is_refused = problem == ENOENT || (is_folder && (problem == EACCES || problem == EPERM));
  if (is_new && is_allowed && is_refused)
    return fmt::format("the system makes no new {} in {}", is_folder ? "folder" : "file", folder.string());
  return path_words(is_folder ? place.string() + "/" : path, problem);
}

ErrorKind output_fault(int problem) noexcept {
  for (const int misnamed :
       {ENOENT, EACCES, EPERM, ELOOP, ENOTDIR, ENAMETOOLONG, EISDIR, EEXIST, EROFS, EINVAL}) {
    if (problem == misnamed) return ErrorKind::usage;
  }
  return ErrorKind::fault;
}

}  // namespace fingerpad
