#include "app/stop_signals.hpp"

#include <semaphore.h>

#include <cmath>
#include <ctime>

namespace fingerpad {
namespace {

constexpr int stop_signals[] = {SIGINT, SIGTERM, SIGHUP};

// A handler reaches nothing but what is global.
sem_t stop_asked;
volatile std::sig_atomic_t stop_has_come = 0;

void ask_to_stop(int) {
  stop_has_come = 1;
  sem_post(&stop_asked);
}

}  // namespace

StopSignals::StopSignals() {
  sem_init(&stop_asked, 0, 0);
  stop_has_come = 0;
  for (int k = 0; k < count; ++k) {
    struct sigaction action {};
    action.sa_handler = ask_to_stop;
    action.sa_flags = SA_RESTART | (stop_signals[k] == SIGINT ? static_cast<int>(SA_RESETHAND) : 0);
    sigemptyset(&action.sa_mask);
    sigaction(stop_signals[k], nullptr, &before_[k]);
    if (before_[k].sa_handler != SIG_IGN) sigaction(stop_signals[k], &action, nullptr);
  }
}

StopSignals::~StopSignals() {
  for (int k = 0; k < count; ++k) sigaction(stop_signals[k], &before_[k], nullptr);
}

bool StopSignals::has_come() const noexcept {
  return stop_has_come != 0;
}

bool StopSignals::wait(double seconds) const noexcept {
  if (has_come()) return true;
  timespec until{};
  clock_gettime(CLOCK_MONOTONIC, &until);
  const auto ns = until.tv_nsec + std::lround(1e9 * seconds);
  until.tv_sec += ns / 1'000'000'000;
  until.tv_nsec = ns % 1'000'000'000;
  sem_clockwait(&stop_asked, CLOCK_MONOTONIC, &until);
  return has_come();
}

}  // namespace fingerpad
