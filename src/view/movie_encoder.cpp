#include "view/movie_encoder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "trace/output_file.hpp"
#include "view/find_program.hpp"

namespace fingerpad {
namespace {

constexpr const char* program_name = "ffmpeg";

std::string found_encoder() {
  std::string program = find_program(program_name);
  if (!program.empty()) return program;
  throw Error(ErrorKind::usage, program_name,
              "is not installed; movies are made by it (apt-get install ffmpeg)");
}

std::vector<std::string> encoder_arguments(const std::string& path, int width, int height,
                                           double frames_per_s) {
  std::vector<std::string> all = {
      program_name, "-loglevel", "error", "-y", "-f", "rawvideo", "-pixel_format", "rgb24", "-video_size",
      fmt::format("{}x{}", width, height), "-framerate", fmt::format("{}", frames_per_s), "-i", "pipe:0",
      // Pixels come from the bottom up. Without its version and the date the same frames give the same bytes.
      "-vf", "vflip", "-map_metadata", "-1", "-fflags", "+bitexact", "-flags:v", "+bitexact", "-pix_fmt",
      "yuv420p"};
  const std::vector<std::string> kind =
      path.ends_with(".ogv") ? std::vector<std::string>{"-c:v", "libtheora", "-q:v", "9", "-f", "ogg"}
                             : std::vector<std::string>{"-c:v", "libx264",   "-preset",    "veryfast", "-crf",
                                                        "18",   "-movflags", "+faststart", "-f",       "mp4"};
  all.insert(all.end(), kind.begin(), kind.end());
  return all;
}

/// In the child, between fork and exec: only calls that are safe there.
[[noreturn]] void become_encoder(const char* program, char* const* arguments, int frames, int words,
                                 pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(127);
  setsid();  // Ctrl-C is for the program, which then ends this one
  dup2(frames, STDIN_FILENO);
  dup2(words, STDOUT_FILENO);
  dup2(words, STDERR_FILENO);
  execv(program, arguments);
  _exit(127);
}

/// All that was written to a file in memory.
std::string text_of(int file) {
  std::string text(1000, '\0');
  const ssize_t count = pread(file, text.data(), text.size(), 0);
  text.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
  while (!text.empty() && text.back() == '\n') text.pop_back();
  const std::size_t last_line = text.rfind('\n');
  return last_line == std::string::npos ? text : text.substr(last_line + 1);
}

}  // namespace

void need_movie_encoder() {
  found_encoder();
}

MovieEncoder::MovieEncoder(const std::string& path, int width, int height, double frames_per_s)
    : path_(path), program_(found_encoder()) {
  int ends[2];
  movie_ = memfd_create("movie", 0);  // which the child inherits
  words_ = memfd_create("words", MFD_CLOEXEC);
  if (movie_ < 0 || words_ < 0 || socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
    throw Error(ErrorKind::fault, program_name, "no memory or no file is left for it");
  frames_ = ends[0];
  std::vector<std::string> words = encoder_arguments(path, width, height, frames_per_s);
  words.push_back(fmt::format("/proc/self/fd/{}", movie_));
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const pid_t parent = getpid();
  process_ = fork();
  if (process_ == 0) become_encoder(program_.c_str(), arguments.data(), ends[1], words_, parent);
  close(ends[1]);
  if (process_ < 0) throw Error(ErrorKind::fault, program_name, "cannot be started");
}

MovieEncoder::~MovieEncoder() {
  if (process_ > 0) {
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
  }
  for (const int file : {frames_, movie_, words_}) {
    if (file >= 0) close(file);
  }
}

int MovieEncoder::wait_for_end() {
  if (frames_ >= 0) close(std::exchange(frames_, -1));
  int status = 0;
  while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
  return status;
}

void MovieEncoder::fail() {
  if (process_ > 0) wait_for_end();
  const std::string said = text_of(words_);
  throw Error(
      ErrorKind::fault, path_,
      fmt::format("{} made no movie of it: {}", program_name, said.empty() ? "it ended early" : said));
}

void MovieEncoder::add(const Pixels& frame) {
  for (std::size_t sent = 0; sent < frame.rgb.size();) {
    // Not by write(), by which a process that has ended would end this one.
    const ssize_t count = send(frames_, frame.rgb.data() + sent, frame.rgb.size() - sent, MSG_NOSIGNAL);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) fail();
    sent += static_cast<std::size_t>(count);
  }
}

void MovieEncoder::finish() {
  if (wait_for_end() != 0) fail();
  OutputFile file(path_);
  std::vector<char> piece(1 << 20);
  for (off_t at = 0;;) {
    const ssize_t count = pread(movie_, piece.data(), piece.size(), at);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) throw Error(ErrorKind::fault, path_, "the movie cannot be read back from memory");
    if (count == 0) break;
    file.write({piece.data(), static_cast<std::size_t>(count)});
    at += count;
  }
  file.commit();
}

}  // namespace fingerpad
