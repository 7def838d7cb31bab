#include "replay/processor_time.hpp"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <thread>
#include <vector>

namespace fingerpad {

double processor_s() noexcept {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double processors_for(int threads) {
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::milliseconds long_enough{400};
  const Clock::time_point start = Clock::now();
  const double before_s = processor_s();
  {
    std::vector<std::jthread> busy;
    busy.reserve(static_cast<std::size_t>(threads));
    for (int i = 0; i < threads; ++i)
      busy.emplace_back([=] {
        while (Clock::now() - start < long_enough) {
        }
      });
  }
  const double taken_s = processor_s() - before_s;
  const double lasted_s = std::chrono::duration<double>(Clock::now() - start).count();
  constexpr double least_share = 0.01;  // of a processor, on a machine that is as good as stopped
  return std::clamp(taken_s / lasted_s, least_share, static_cast<double>(threads));
}

double shared_seconds(double work_s, double longest_s, int threads, double processors) noexcept {
  const double of_one_thread = std::min(1.0, processors / threads);
  return std::max(longest_s / of_one_thread, work_s / processors);
}

}  // namespace fingerpad
