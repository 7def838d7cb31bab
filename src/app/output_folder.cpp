#include "app/output_folder.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include "base/error.hpp"
#include "base/path_words.hpp"
#include "trace/output_file.hpp"

namespace fingerpad {
namespace {

namespace fs = std::filesystem;

/// What is to be made for a path to be there, innermost first.
std::vector<fs::path> missing_folders(fs::path path) {
  if (!path.has_filename()) path = path.parent_path();  // "out/"
  std::vector<fs::path> missing;
  std::error_code ignored;
  while (!path.empty() && !fs::exists(fs::symlink_status(path, ignored))) {
    missing.push_back(path);
    path = path.parent_path();
  }
  return missing;
}

void remove_empty(const std::vector<fs::path>& folders) {
  for (const fs::path& folder : folders) rmdir(folder.c_str());  // fails where something is in it
}

}  // namespace

OutputFolder::OutputFolder(const std::string& path) {
  const std::vector<fs::path> missing = missing_folders(path);
  std::error_code error;
  const auto status = fs::status(path, error);
  if (fs::exists(status) && !fs::is_directory(status)) {
    throw Error(ErrorKind::usage, path, fmt::format("cannot be made: {} is a file, not a folder", path));
  }
  fs::create_directories(path, error);
  if (error) {
    remove_empty(missing);
    throw Error(output_fault(error.value()), path,
                "cannot be made: " + unmade_words(path, error.value(), Made::folder));
  }
  try {
    const fs::path trial = fs::path(path) / fmt::format(".fingerpad-{}", getpid());
    OutputFile file(trial.string());
    file.write("can this be written?\n");
    file.commit();
    fs::remove(trial, error);
  } catch (const Error&) {
    remove_empty(missing);
    throw;
  }
  made_ = missing;
}

OutputFolder::~OutputFolder() {
  remove_empty(made_);
}

}  // namespace fingerpad
