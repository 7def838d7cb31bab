#include "app/headless.hpp"

#include <semaphore.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <ctime>
#include <functional>

#include "app/standard_streams.hpp"
#include "device/terminal_keys.hpp"

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

/// Waits for so many seconds, without end where none are given, until SIGINT or SIGTERM comes, or until
/// `is_over` says so, which is asked many times a second.
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

}  // namespace

void run_headless(std::optional<double> seconds, const std::string& name, LiveDevice& device) {
  std::atomic<bool> quit{false};
  std::optional<TerminalKeys> keys;
  if (device.has_motors() && has_terminal_keys()) {
    print_err("fingerpad: {}: x: emergency stop, and the force back; q: end\n", name);
    keys.emplace([&](std::string_view key) {
      if (key == "q") quit = true;
      if (key != "x") return;
      device.set_emergency_stop(!device.emergency_stopped());
      print_err("fingerpad: {}: {}\n", name,
                device.emergency_stopped() ? "STOPPED, x gives the force back" : "goes on");
    });
  }
  wait_without_window(seconds, [&] { return quit || device.has_ended(); });
}

}  // namespace fingerpad
