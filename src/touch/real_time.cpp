#include "touch/real_time.hpp"

#include <fmt/format.h>
#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>

namespace fingerpad {
namespace {

/// Above what drivers usually take, below the system's own threads.
constexpr int servo_priority = 80;

}  // namespace

void sharpen_timers() noexcept {
  prctl(PR_SET_TIMERSLACK, 1UL, 0UL, 0UL, 0UL);
}

void ask_for_short_turns() noexcept {
  if (sched_getscheduler(0) != SCHED_OTHER) return;  // whoever began the program chose another
  // As <linux/sched/types.h> has it, which some C libraries define once more.
  struct Attributes {
    std::uint32_t size, policy;
    std::uint64_t flags;
    std::int32_t nice;
    std::uint32_t priority;
    std::uint64_t runtime_ns, deadline_ns, period_ns;
  };
  constexpr std::uint64_t shortest_ns = 100'000;  // that Linux grants
  const int nice = getpriority(PRIO_PROCESS, static_cast<id_t>(gettid()));
  Attributes wanted{sizeof(Attributes), SCHED_OTHER, 0, nice, 0, shortest_ns, 0, 0};
  syscall(SYS_sched_setattr, 0, &wanted, 0);
}

std::vector<std::string> run_thread_first() {
  std::vector<std::string> refused;
  sched_param wanted{};
  wanted.sched_priority = servo_priority;
  if (const int error = pthread_setschedparam(pthread_self(), SCHED_FIFO, &wanted); error != 0) {
    refused.push_back(
        fmt::format("--realtime: SCHED_FIFO is not permitted ({}): give the user an rtprio of {} in "
                    "/etc/security/limits.conf, or the program CAP_SYS_NICE; going on without",
                    std::strerror(error), servo_priority));
  }
  cpu_set_t cores, last;
  CPU_ZERO(&cores);
  CPU_ZERO(&last);
  int error = pthread_getaffinity_np(pthread_self(), sizeof(cores), &cores);
  for (int core = CPU_SETSIZE - 1; error == 0 && core >= 0; --core) {
    if (!CPU_ISSET(core, &cores)) continue;
    CPU_SET(core, &last);
    error = pthread_setaffinity_np(pthread_self(), sizeof(last), &last);
    break;
  }
  if (error != 0) {
    refused.push_back(fmt::format("--realtime: the loop cannot be kept on one core ({}); going on without",
                                  std::strerror(error)));
  }
  return refused;
}

std::vector<std::string> lock_memory() {
  // With a limit, memory that is asked for later might be refused: then only what there is now is locked.
  rlimit limit{};
  const bool unlimited = getrlimit(RLIMIT_MEMLOCK, &limit) == 0 && limit.rlim_cur == RLIM_INFINITY;
  if (mlockall(unlimited ? MCL_CURRENT | MCL_FUTURE : MCL_CURRENT) == 0) return {};
  return {
      fmt::format("--realtime: memory cannot be locked ({}): raise memlock in /etc/security/limits.conf; "
                  "going on without",
                  std::strerror(errno))};
}

}  // namespace fingerpad
