#include "base/input_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <utility>

#include "base/error.hpp"
#include "base/path_words.hpp"
#include "base/printable_text.hpp"

namespace fingerpad {
namespace {

/// What something that is no regular file is; empty for a regular one.
std::string_view other_than_regular(mode_t mode) {
  if (S_ISREG(mode)) return {};
  if (S_ISDIR(mode)) return "a folder";
  if (S_ISFIFO(mode)) return "a pipe";
  if (S_ISSOCK(mode)) return "a socket";
  return "a device";
}

std::string refusal_of(mode_t mode, const InputKind& kind) {
  if (S_ISDIR(mode)) return fmt::format("is a folder, not {}", kind.what);
  std::string words = fmt::format("is {}, not a regular file", other_than_regular(mode));
  if (S_ISFIFO(mode) && kind.stream) return words + ": lead it to standard input and give `-`";
  if (S_ISFIFO(mode)) return words + fmt::format(": write {} to a file first", kind.what);
  return words;
}

/// A stat that waits for nothing. Opening a device, even to look at it, can move it.
void refuse_irregular(const struct stat& status, const InputKind& kind, const std::string& where) {
  if (!S_ISREG(status.st_mode)) throw refused(where, refusal_of(status.st_mode, kind));
}

Error unreadable(const std::string& where, const std::string& path, int problem) {
  return refused(where, "cannot be read: " + path_words(path, problem));
}

}  // namespace

std::optional<int> stream_descriptor(std::string_view path) noexcept {
  if (path == "-" || path == "/dev/stdin") return STDIN_FILENO;
  for (const std::string_view folder : {"/dev/fd/", "/proc/self/fd/"}) {
    if (!path.starts_with(folder)) continue;
    const std::string_view digits = path.substr(folder.size());
    int number = 0;
    const auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (problem == std::errc() && end == digits.data() + digits.size() && number >= 0) return number;
  }
  return std::nullopt;
}

std::string input_name(const std::string& path) {
  return path == "-" ? "standard input" : path;
}

std::string bytes_text(std::uint64_t bytes) {
  constexpr std::string_view units[] = {"bytes", "KiB", "MiB", "GiB", "TiB"};
  std::size_t unit = 0;
  for (; unit + 1 < std::size(units) && bytes >= 1024 && bytes % 1024 == 0; ++unit) bytes /= 1024;
  return fmt::format("{} {}", bytes, units[unit]);
}

InputFile::InputFile(const std::string& path, const InputKind& kind, std::string where)
    : kind_(kind), where_(std::move(where)) {
  const auto descriptor = stream_descriptor(path);
  if (descriptor && kind_.stream) {
    open_stream(*descriptor);
    return;
  }
  if (path == "-" && access("-", F_OK) != 0) {
    throw refused(where_, fmt::format("cannot be {} here, since that is read more than once: write it to a "
                                      "file and name that",
                                      kind_.what));
  }
  open_regular(path);
}

InputFile::~InputFile() {
  if (file_ >= 0) close(file_);
}

void InputFile::open_stream(int descriptor) {
  waits_ = true;
  file_ = fcntl(descriptor, F_DUPFD_CLOEXEC, 0);
  struct stat status {};
  if (file_ < 0 || fstat(file_, &status) != 0) throw refused(where_, "cannot be read: it is not open");
  if (S_ISDIR(status.st_mode)) throw refused(where_, refusal_of(status.st_mode, kind_));
}

void InputFile::open_regular(const std::string& path) {
  struct stat status {};
  if (path.find('\0') != std::string::npos) {
    throw refused(printable(where_), "a file's name cannot hold a zero byte");
  }
  if (stat(path.c_str(), &status) != 0) throw unreadable(where_, path, errno);
  refuse_irregular(status, kind_, where_);
  // Between the two looks a pipe may have taken the file's place: it is opened without waiting, and the
  // second look refuses it.
  file_ = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
  if (file_ < 0 || fstat(file_, &status) != 0) throw unreadable(where_, path, errno);
  try {
    refuse_irregular(status, kind_, where_);
    size_ = static_cast<std::uint64_t>(std::max<off_t>(status.st_size, 0));
    if (size_ > kind_.most_bytes) {
      throw refused(where_, fmt::format("has {} bytes; of {} more than {} are not read", size_, kind_.what,
                                        bytes_text(kind_.most_bytes)));
    }
  } catch (...) {
    close(std::exchange(file_, -1));
    throw;
  }
}

std::size_t InputFile::read(char* to, std::size_t count) {
  std::size_t done = 0;
  while (done < count) {
    const ssize_t got = ::read(file_, to + done, count - done);
    if (got == 0) break;
    if (got < 0 && errno == EINTR) continue;
    if (got < 0 && errno == EAGAIN && waits_) {
      pollfd wait{file_, POLLIN, 0};  // another program made the stream one that does not wait
      poll(&wait, 1, -1);
      continue;
    }
    if (got < 0) throw unreadable(where_, where_, errno);
    done += static_cast<std::size_t>(got);
    taken_ += static_cast<std::uint64_t>(got);
    if (taken_ > kind_.most_bytes) {
      throw refused(where_, fmt::format("does not end within {}; of {} more are not read",
                                        bytes_text(kind_.most_bytes), kind_.what));
    }
  }
  return done;
}

std::string read_whole_file(const std::string& path, const InputKind& kind, const std::string& where) {
  InputFile file(path, kind, where);
  // A byte more than there should be shows the end; what grows on goes in steps.
  std::string bytes(static_cast<std::size_t>(file.size()) + 1, '\0');
  std::size_t filled = 0;
  while (true) {
    filled += file.read(bytes.data() + filled, bytes.size() - filled);
    if (filled < bytes.size()) break;
    bytes.resize(bytes.size() + std::max<std::size_t>(bytes.size() / 2, 1 << 16));
  }
  bytes.resize(filled);
  return bytes;
}

std::string read_whole_file(const std::string& path, const InputKind& kind) {
  return read_whole_file(path, kind, input_name(path));
}

std::optional<std::string> why_unreadable(const std::string& path, const InputKind& kind) {
  try {
    const InputFile file(path, kind, "");
    return std::nullopt;
  } catch (const Error& error) {
    return error.what();
  }
}

}  // namespace fingerpad
