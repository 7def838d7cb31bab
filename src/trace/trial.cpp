#include "trace/trial.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>

#include "base/error.hpp"

namespace fingerpad {
namespace {

constexpr char returned_letter = 'r', threw_letter = 't', waited_letter = 'w';
constexpr std::size_t max_message_bytes = 4000;  // less than any pipe holds, so that the child never waits
constexpr int words_capacity_bytes = 1 << 20;

void limit(int resource, rlim_t value) {
  rlimit now{};
  if (getrlimit(resource, &now) != 0) return;
  if (now.rlim_max != RLIM_INFINITY && now.rlim_max < value) return;
  const rlimit wanted{value, value};
  setrlimit(resource, &wanted);
}

/// What this process holds already, in bytes; 0 if that cannot be told.
rlim_t held_bytes() {
  std::ifstream statm("/proc/self/statm");
  rlim_t field = 0;
  for (int i = 0; i < 6; ++i) statm >> field;  // the sixth: data and stack, in pages
  return statm ? field * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) : 0;
}

/// Where the child tells how it ended, for a signal's handler.
volatile std::sig_atomic_t ending_of_child = -1;

extern "C" void tell_of_waiting(int) {
  const ssize_t count = write(ending_of_child, &waited_letter, 1);
  _exit(count == 1 ? 0 : 1);
}

/// A crash ends the child with no words of anybody's handlers. What asks the whole group of processes to end
/// is for the parent to answer: the child ends when nobody hears it any more.
void settle_signals() {
  for (const int number : {SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL, SIGXCPU, SIGPIPE}) {
    std::signal(number, SIG_DFL);
  }
  std::signal(SIGALRM, tell_of_waiting);
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) std::signal(number, SIG_IGN);
}

bool write_all(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = write(file, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

[[noreturn]] void run_in_child(const std::function<void(const Trial::Say&)>& work, const TrialLimits& limits,
                               int words, int ending) {
  ending_of_child = ending;
  settle_signals();
  // Of what takes no time of the processor; before anything that asks for memory, which may wait for ever.
  alarm(static_cast<unsigned>(wait_seconds(limits)));
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_CPU, limits.seconds);
  if (const rlim_t held = held_bytes()) limit(RLIMIT_DATA, held + limits.memory_bytes);
  // The C library says "free(): invalid pointer" before it aborts: that is for nobody's eyes.
  if (const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC); nowhere >= 0) dup2(nowhere, STDERR_FILENO);
  std::string end(1, returned_letter);
  try {
    work([words](std::string_view bytes) {
      if (!write_all(words, bytes)) _exit(1);
    });
  } catch (const Error& error) {
    end = threw_letter + std::string(error.what()).substr(0, max_message_bytes);
  } catch (...) {
    _exit(1);
  }
  _exit(write_all(ending, end) ? 0 : 1);
}

struct Pipe {
  int out = -1, in = -1;
};

/// Above the three standard files, which may be closed here and are opened anew in the child.
Pipe make_pipe() {
  int ends[2] = {-1, -1};
  if (pipe2(ends, O_CLOEXEC) != 0) return {};
  for (int& end : ends) {
    const int low = end;
    end = fcntl(low, F_DUPFD_CLOEXEC, 3);
    const int failure = errno;
    close(low);
    errno = failure;
  }
  return {ends[0], ends[1]};
}

ssize_t read_some(int file, std::span<char> out) {
  while (true) {
    const ssize_t count = read(file, out.data(), out.size());
    if (count >= 0 || errno != EINTR) return count;
  }
}

}  // namespace

std::uint64_t wait_seconds(const TrialLimits& limits) noexcept {
#ifdef __SANITIZE_ADDRESS__
  constexpr std::uint64_t patience = 20;  // there a child may wait for nobody
#else
  constexpr std::uint64_t patience = 60;
#endif
  return patience + 10 * limits.seconds;
}

Trial::Trial(const std::function<void(const Say&)>& work, const TrialLimits& limits) {
  const Pipe words = make_pipe(), ending = make_pipe();
  child_ = ending.in >= 0 && words.in >= 0 ? fork() : -1;
  const int failure = errno;
  if (child_ >= 0) fcntl(words.in, F_SETPIPE_SZ, words_capacity_bytes);  // fewer waits; refused if too much
  if (child_ == 0) {
    close(words.out);
    close(ending.out);
    run_in_child(work, limits, words.in, ending.in);
  }
  close(words.in);
  close(ending.in);
  words_ = words.out;
  ending_ = ending.out;
  if (child_ > 0) return;
  close(words_);
  close(ending_);
  throw Error(ErrorKind::fault, "", std::string("no process can be started: ") + std::strerror(failure));
}

Trial::~Trial() {
  if (child_ <= 0) return;
  kill(child_, SIGKILL);
  release();
}

void Trial::release() {
  close(words_);
  close(ending_);
  while (waitpid(child_, nullptr, 0) < 0 && errno == EINTR) {
  }
  child_ = -1;
}

bool Trial::fill() {
  heard_.resize(std::size_t{1} << 18);
  used_ = 0;
  const ssize_t count = read_some(words_, heard_);
  heard_.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
  return count > 0;
}

bool Trial::hear(std::span<char> out) {
  while (!out.empty()) {
    if (used_ == heard_.size() && !fill()) return false;
    const std::size_t count = std::min(out.size(), heard_.size() - used_);
    std::memcpy(out.data(), heard_.data() + used_, count);
    used_ += count;
    out = out.subspan(count);
  }
  return true;
}

/// The letter and the message tell, not the child's status: where SIGCHLD is ignored there is none.
TrialOutcome Trial::end() {
  if (child_ <= 0) return {};
  while (fill()) {
  }
  std::string told(max_message_bytes + 1, '\0');
  const ssize_t count = read_some(ending_, told);
  told.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
  release();
  if (told.empty()) return {};
  if (told.front() == waited_letter) return {TrialOutcome::End::waited, ""};
  if (told.front() == returned_letter) return {TrialOutcome::End::returned, ""};
  return {TrialOutcome::End::threw, told.substr(1)};
}

}  // namespace fingerpad
