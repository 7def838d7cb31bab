#include "view/drawing_threads.hpp"

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

}  // namespace

DrawingThreads::DrawingThreads() : others_(threads_now()) {
  others_.erase(gettid());
}

void DrawingThreads::stand_back() const {
  constexpr int how_far = 10;
  for (const int thread : threads_now()) {
    const auto id = static_cast<id_t>(thread);
    // Who stands farther back already is not to come forward.
    if (!others_.contains(thread) && getpriority(PRIO_PROCESS, id) < how_far)
      setpriority(PRIO_PROCESS, id, how_far);
  }
}

}  // namespace fingerpad
