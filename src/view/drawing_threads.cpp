#include "view/drawing_threads.hpp"

#include <sched.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>

namespace fingerpad {
namespace {

/// Linux' own numbers of this process's threads.
std::set<int> threads_now() {
  std::set<int> threads;
  std::error_code none;  // another system, or a closed /proc: then there are none to tell
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/task", none))
    threads.insert(std::atoi(entry.path().filename().c_str()));
  return threads;
}

/// The cores that the calling thread may use but the last; all where there is but one.
cpu_set_t all_cores_but_the_last() {
  cpu_set_t cores;
  CPU_ZERO(&cores);
  if (sched_getaffinity(0, sizeof(cores), &cores) != 0 || CPU_COUNT(&cores) < 2) return cores;
  int last = CPU_SETSIZE - 1;
  while (!CPU_ISSET(last, &cores)) --last;
  CPU_CLR(last, &cores);
  return cores;
}

}  // namespace

DrawingThreads::DrawingThreads() : others_(threads_now()) {
  others_.erase(gettid());
}

void DrawingThreads::stand_back() const {
  constexpr int how_far = 10;
  // A thread that draws a second window has left its core already.
  static const cpu_set_t cores = all_cores_but_the_last();
  for (const int thread : threads_now()) {
    const auto id = static_cast<id_t>(thread);
    if (others_.contains(thread)) continue;
    // Who stands farther back already is not to come forward.
    if (getpriority(PRIO_PROCESS, id) < how_far) setpriority(PRIO_PROCESS, id, how_far);
    if (CPU_COUNT(&cores) > 0) sched_setaffinity(thread, sizeof(cores), &cores);
  }
}

}  // namespace fingerpad
