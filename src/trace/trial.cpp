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

constexpr int threw_status = 3;
constexpr std::size_t max_message_bytes = 4000;  // less than any pipe holds, so that the child never waits

[[noreturn]] void run_in_child(const std::function<void()>& work, std::uint64_t seconds,
                               std::uint64_t memory_bytes, int message_pipe) {
  for (const int number : {SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL, SIGXCPU, SIGALRM}) {
    std::signal(number, SIG_DFL);
  }
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_CPU, seconds);
  if (const rlim_t held = held_bytes()) limit(RLIMIT_DATA, held + memory_bytes);
  alarm(static_cast<unsigned>(3 * seconds));  // a wait that takes no time of the processor
  // The C library says "free(): invalid pointer" before it aborts: that is for nobody's eyes.
  close(STDERR_FILENO);
  try {
    work();
  } catch (const std::exception& error) {
    const std::size_t size = std::min(std::strlen(error.what()), max_message_bytes);
    const bool sent = write(message_pipe, error.what(), size) == static_cast<ssize_t>(size);
    _exit(sent ? threw_status : 1);
  }
  _exit(0);
}

}  // namespace

TrialOutcome trial(const std::function<void()>& work, std::uint64_t seconds, std::uint64_t memory_bytes) {
  int ends[2] = {-1, -1};
  const pid_t child = pipe2(ends, O_CLOEXEC) == 0 ? fork() : -1;
  if (child < 0)
    throw Error(ErrorKind::fault, "", std::string("no process can be started: ") + std::strerror(errno));
  if (child == 0) run_in_child(work, seconds, memory_bytes, ends[1]);
  close(ends[1]);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  TrialOutcome outcome;
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) outcome.end = TrialOutcome::End::returned;
  if (WIFEXITED(status) && WEXITSTATUS(status) == threw_status) {
    outcome.end = TrialOutcome::End::threw;
    outcome.message.resize(max_message_bytes);
    const ssize_t size = read(ends[0], outcome.message.data(), outcome.message.size());
    outcome.message.resize(size > 0 ? static_cast<std::size_t>(size) : 0);
  }
  close(ends[0]);
  return outcome;
}

}  // namespace fingerpad
