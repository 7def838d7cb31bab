#pragma once

#include <condition_variable>
#include <functional>
#include <future>
#include <mutex>
#include <thread>
#include <type_traits>

namespace fingerpad {

/// A thread that keeps how the one that made it stood with the system then. On Linux a thread is born with
/// its maker's priority, and one that has stood back may not come forward again: what is begun here stands as
/// if the maker never had.
class KeptThread {
 public:
  KeptThread();
  ~KeptThread();
  KeptThread(const KeptThread&) = delete;
  KeptThread& operator=(const KeptThread&) = delete;

  /// Does it there, waits for its end, and returns or throws what it does. Called by one thread at a time.
  template <typename Work>
  auto run(Work&& work) {
    std::packaged_task<std::invoke_result_t<Work>()> task(std::forward<Work>(work));
    auto result = task.get_future();
    hand_over([&task] { task(); });
    return result.get();
  }

 private:
  /// Returns when it is done.
  void hand_over(const std::function<void()>& work);
  void serve();

  std::mutex mutex_;
  std::condition_variable changed_;
  const std::function<void()>* work_ = nullptr;
  bool is_over_ = false;
  std::thread thread_;
};

}  // namespace fingerpad
