#include "app/headless.hpp"

#include <semaphore.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <ctime>

namespace fingerpad {
namespace {

// A handler reaches nothing but what is global.
sem_t asked_to_stop;

void ask_to_stop(int) {
  sem_post(&asked_to_stop);
}

/// While it lives SIGINT and SIGTERM ask to stop, the first time that each comes.
class StopSignals {
 public:
  StopSignals() {
    sem_init(&asked_to_stop, 0, 0);
    struct sigaction action {};
    action.sa_handler = ask_to_stop;
    action.sa_flags = SA_RESETHAND | SA_RESTART;
    sigemptyset(&action.sa_mask);
    sigaction(SIGINT, &action, &before_int_);
    sigaction(SIGTERM, &action, &before_term_);
  }
  ~StopSignals() {
    sigaction(SIGINT, &before_int_, nullptr);
    sigaction(SIGTERM, &before_term_, nullptr);
  }
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;

  /// @returns whether a signal has come
  bool wait(double seconds) const {
    timespec until{};
    clock_gettime(CLOCK_MONOTONIC, &until);
    const auto ns = until.tv_nsec + static_cast<long>(1e9 * seconds);
    until.tv_sec += ns / 1'000'000'000;
    until.tv_nsec = ns % 1'000'000'000;
    return sem_clockwait(&asked_to_stop, CLOCK_MONOTONIC, &until) == 0;
  }

 private:
  struct sigaction before_int_ {
  }, before_term_{};
};

}  // namespace

void wait_without_window(std::optional<double> seconds, const std::function<bool()>& is_over) {
  using Clock = std::chrono::steady_clock;
  constexpr double look_s = 0.05;
  const StopSignals signals;
  const Clock::time_point start = Clock::now();
  for (;;) {
    double wait_s = look_s;
    if (seconds) {
      const double left_s = *seconds - std::chrono::duration<double>(Clock::now() - start).count();
      if (left_s <= 0) return;
      wait_s = std::min(wait_s, left_s);
    }
    if (signals.wait(wait_s) || is_over()) return;
  }
}

}  // namespace fingerpad
