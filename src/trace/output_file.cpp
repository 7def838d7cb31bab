#include "trace/output_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

#include "base/error.hpp"
#include "base/output_place.hpp"

namespace fingerpad {
namespace {

/// A pipe or a device as a stream; without waiting for somebody to read it.
std::FILE* open_irregular(const std::string& path) {
  const int file = open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK);
  if (file < 0) return nullptr;
  fcntl(file, F_SETFL, fcntl(file, F_GETFL) & ~O_NONBLOCK);
  std::FILE* const stream = fdopen(file, "wb");
  if (stream == nullptr) close(file);
  return stream;
}

}  // namespace

OutputFile::OutputFile(const std::string& path) : path_(path), written_path_(path) {
  if (path == "-") {
    path_ = "standard output";
    file_ = stdout;
    return;
  }
  refuse_unwritable(path);
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
    file_ = open_irregular(path);
  } else {
    written_path_ += ".part";
    file_ = std::fopen(written_path_.c_str(), "wbe");
  }
  if (file_ == nullptr && errno == ENXIO) {
    throw Error(ErrorKind::fault, path_, "is a pipe that nobody reads: start its reader first");
  }
  if (file_ == nullptr) fail("cannot be created");
}

OutputFile::~OutputFile() {
  if (file_ != nullptr && file_ != stdout) std::fclose(file_);
}

void OutputFile::fail(const std::string& doing) const {
  throw Error(ErrorKind::fault, path_, doing + ": " + std::strerror(errno));
}

void OutputFile::write(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), file_) != text.size()) fail("cannot be written");
}

void OutputFile::flush() {
  if (std::fflush(file_) != 0) fail("cannot be written");
}

void OutputFile::commit() {
  std::FILE* const file = std::exchange(file_, nullptr);
  if ((file == stdout ? std::fflush(file) : std::fclose(file)) != 0) fail("cannot be written");
  if (file == stdout) return;
  if (written_path_ != path_ && std::rename(written_path_.c_str(), path_.c_str()) != 0)
    fail("cannot be renamed");
}

}  // namespace fingerpad
