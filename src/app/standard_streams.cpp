#include "app/standard_streams.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>

#include "base/error.hpp"

namespace fingerpad {
namespace {

/// errno of the first write to standard output that failed; the stream itself forgets it. One for the
/// process, as the stream is.
int output_failure = 0;

}  // namespace

void guard_standard_streams() noexcept {
  for (const int number : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(number, F_GETFD) >= 0 || errno != EBADF) continue;
    // Opened the wrong way round: reading and writing fail, as they would have. The lowest free number is
    // this one, since those below are open by now.
    open("/dev/null", number == STDIN_FILENO ? O_WRONLY : O_RDONLY);
  }
  std::signal(SIGXFSZ, SIG_IGN);
}

void write_stream(std::FILE* stream, std::string_view text) noexcept {
  // Where both go to one file, what is said comes in the order in which it is said.
  if (stream == stderr && std::fflush(stdout) != 0 && output_failure == 0) output_failure = errno;
  const bool written = std::fwrite(text.data(), 1, text.size(), stream) == text.size();
  if (!written && stream == stdout && output_failure == 0) output_failure = errno;
}

int close_standard_streams(int code) noexcept {
  const int fault = code != 0 ? code : static_cast<int>(ErrorKind::fault);
  if (std::fflush(stdout) != 0 && output_failure == 0) output_failure = errno;
  if (output_failure != 0) {
    std::fprintf(stderr, "fingerpad: error: standard output: cannot be written: %s\n",
                 std::strerror(output_failure));
    code = fault;
  }
  if (std::fflush(stderr) != 0 || std::ferror(stderr) != 0) code = fault;
  return code;
}

}  // namespace fingerpad
