#include "replay/watched_rank.hpp"

#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <ctime>
#include <new>

#include "base/error.hpp"

namespace fingerpad {

struct WatchedRank::Told {
  std::atomic<long> begun{0};
  std::atomic<bool> left{false};
};

namespace {

constexpr int most_idle_deaths = 3;

sigset_t watched_signals() noexcept {
  sigset_t set;
  sigemptyset(&set);
  for (const int signal : {SIGCHLD, SIGINT, SIGTERM}) sigaddset(&set, signal);
  return set;
}

/// As waitpid tells of a child that has ended with this code.
constexpr int status_of_exit(ErrorKind code) noexcept {
  return static_cast<int>(code) << 8;
}

/// How a child ended: as waitpid's status, and whether it had been asked to stop.
struct ChildEnd {
  int status = 0;
  bool asked = false;
};

ChildEnd watch_over(pid_t child, pid_t launcher, const std::function<void()>& on_asked) {
  const sigset_t set = watched_signals();
  for (ChildEnd end;;) {
    const pid_t ended = waitpid(child, &end.status, WNOHANG);
    if (ended == child) return end;
    if (ended < 0 && errno != EINTR) {  // gone, nobody knows how; its number may be another's by now
      end.status = status_of_exit(ErrorKind::fault);
      return end;
    }
    const timespec patience{1, 0};
    const int signal = sigtimedwait(&set, nullptr, &patience);
    if (signal == SIGINT || signal == SIGTERM) {
      kill(child, signal);
      if (!end.asked && on_asked) on_asked();
      end.asked = true;
    } else if (!end.asked && getppid() != launcher) {
      kill(child, SIGTERM);
      end.asked = true;
    }
  }
}

}  // namespace

WatchedRank::WatchedRank(RankLog& log, const Ranks& ranks, const std::function<void()>& on_asked) {
  void* const memory = mmap(nullptr, sizeof(Told), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) throw Error(ErrorKind::fault, "", "no memory is left for a rank");
  told_ = new (memory) Told;
  const pid_t watcher = getpid();
  signal(SIGCHLD, SIG_DFL);  // where whoever started this one ignores it, the kernel keeps no child's end
  const sigset_t set = watched_signals();
  sigset_t before;
  sigprocmask(SIG_BLOCK, &set, &before);
  long begun = 0;
  for (int idle_deaths = 0; idle_deaths < most_idle_deaths;) {
    const pid_t child = fork();
    if (child < 0) throw Error(ErrorKind::fault, "", "a rank's process cannot be started");
    if (child == 0) {
      prctl(PR_SET_PDEATHSIG, SIGKILL);
      if (getppid() != watcher) _exit(static_cast<int>(ErrorKind::fault));
      signal(SIGPIPE, SIG_IGN);  // that nobody listens any more ends no job
      setpgid(0, 0);             // a launcher's signal to the group comes once, from the watcher
      sigprocmask(SIG_SETMASK, &before, nullptr);
      return;
    }
    const ChildEnd end = watch_over(child, ranks.launcher, on_asked);
    if (WIFEXITED(end.status)) _exit(WEXITSTATUS(end.status));
    log.died(WTERMSIG(end.status));
    if (told_->left || end.asked) _exit(static_cast<int>(ErrorKind::fault));
    idle_deaths = told_->begun == begun ? idle_deaths + 1 : 0;
    begun = told_->begun;
  }
  _exit(static_cast<int>(ErrorKind::fault));
}

void WatchedRank::begins_job() noexcept {
  ++told_->begun;
}

void WatchedRank::has_left() noexcept {
  told_->left = true;
}

}  // namespace fingerpad
