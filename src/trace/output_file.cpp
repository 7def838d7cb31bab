#include "trace/output_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <utility>

#include "base/error.hpp"
#include "base/input_file.hpp"
#include "base/output_place.hpp"
#include "base/path_words.hpp"

namespace fingerpad {
namespace {

/// What a path leads to, through its symbolic links: a file, also one that is not there yet, or one of the
/// streams that this process was given (/dev/stdout is a link to /proc/self/fd/1).
std::string behind_links(std::string path) {
  constexpr int most_links = 40;  // the system's own limit
  std::error_code none;
  for (int k = 0; k < most_links && !stream_descriptor(path) && std::filesystem::is_symlink(path, none);
       ++k) {
    const std::filesystem::path link(path), target = std::filesystem::read_symlink(link, none);
    if (none) break;
    path = (link.parent_path() / target).string();
  }
  return path;
}

/// Another descriptor for a stream that this process was given, such as /dev/stdout.
std::FILE* open_given(int descriptor) {
  const int file = fcntl(descriptor, F_DUPFD_CLOEXEC, 3);
  std::FILE* const stream = file < 0 ? nullptr : fdopen(file, "wb");
  if (stream == nullptr && file >= 0) close(file);
  return stream;
}

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

OutputFile::OutputFile(const std::string& path, Unfinished unfinished)
    : path_(path), final_path_(behind_links(path)), unfinished_(unfinished) {
  if (path == "-") {
    path_ = "standard output";
    file_ = stdout;
    return;
  }
  refuse_unwritable(path);
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  if (const auto given = stream_descriptor(final_path_)) {
    file_ = open_given(*given);
  } else if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
    file_ = open_irregular(path);
  } else {
    part_path_ = final_path_ + ".part";
    file_ = std::fopen(part_path_.c_str(), "wbe");
    // Who may read a file that is replaced was for its owner to say.
    if (file_ != nullptr && std::filesystem::exists(status))
      fchmod(fileno(file_), static_cast<mode_t>(status.permissions()));
  }
  if (file_ == nullptr && errno == ENXIO) {
    throw Error(ErrorKind::fault, path_, "is a pipe that nobody reads: start its reader first");
  }
  if (file_ == nullptr) {
    const int problem = errno;
    throw Error(output_fault(problem), path_,
                "cannot be created: " + unmade_words(path_, problem, Made::file));
  }
}

OutputFile::~OutputFile() {
  if (file_ != nullptr && file_ != stdout) std::fclose(file_);
  if (unfinished_ == Unfinished::removed && !part_path_.empty()) unlink(part_path_.c_str());
}

void OutputFile::fail(const std::string& doing) const {
  throw Error(ErrorKind::fault, path_, doing + ": " + path_words(path_, errno));
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
  if (!part_path_.empty() && std::rename(part_path_.c_str(), final_path_.c_str()) != 0)
    fail("cannot be renamed");
  part_path_.clear();
}

}  // namespace fingerpad
