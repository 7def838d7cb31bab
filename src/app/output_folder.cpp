#include "app/output_folder.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include "base/error.hpp"
#include "base/output_place.hpp"
#include "trace/output_file.hpp"

namespace fingerpad {
namespace {

namespace fs = std::filesystem;

}  // namespace

OutputFolder::OutputFolder(const std::string& path) {
  std::error_code error;
  const auto status = fs::status(path, error);
  if (fs::exists(status) && !fs::is_directory(status)) {
    throw Error(ErrorKind::usage, path, fmt::format("cannot be made: {} is a file, not a folder", path));
  }
  made_ = make_folder(path);
  try {
    const fs::path trial = fs::path(path) / fmt::format(".fingerpad-{}", getpid());
    OutputFile file(trial.string());
    file.write("can this be written?\n");
    file.commit();
    fs::remove(trial, error);
  } catch (const Error&) {
    remove_empty(made_);
    throw;
  }
}

OutputFolder::~OutputFolder() {
  remove_empty(made_);
}

}  // namespace fingerpad
