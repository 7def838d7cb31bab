#include "touch/servo_thread.hpp"

#include <pthread.h>

#include <algorithm>
#include <cmath>
#include <ctime>

#include "touch/real_time.hpp"

namespace fingerpad {
namespace {

constexpr long ns_per_s = 1000000000;

long now_ns() noexcept {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return now.tv_sec * ns_per_s + now.tv_nsec;
}

void sleep_until_ns(long due_ns) noexcept {
  const timespec due{due_ns / ns_per_s, due_ns % ns_per_s};
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &due, nullptr) == EINTR) {
  }
}

/// A ring holds this much more than its readers ask for, so that the writer does not overtake them.
constexpr double spare = 1.25;

}  // namespace

ServoThread::ServoThread(double rate_hz, Tick tick, double history_s, bool real_time, WarmUp warm_up)
    : rate_hz_(rate_hz),
      tick_(std::move(tick)),
      history_(std::max<std::size_t>(16, static_cast<std::size_t>(spare * history_s * rate_hz))) {
  thread_ = std::thread([this, real_time, &warm_up] { run(real_time, warm_up); });
  ready_.wait(false);
}

ServoThread::~ServoThread() {
  stop();
}

void ServoThread::stop() {
  stopping_ = true;
  if (thread_.joinable()) thread_.join();
}

TickRecord ServoThread::latest() const {
  TickRecord record;
  // Overtaken in between: the next is newer still.
  for (std::uint64_t newest = history_.count(); newest > 0 && !history_.get(newest, record);)
    newest = history_.count();
  return record;
}

std::vector<TickRecord> ServoThread::recent(double seconds) const {
  const std::uint64_t newest = history_.count();
  const auto wanted = static_cast<std::uint64_t>(std::max(0.0, seconds * rate_hz_));
  const std::uint64_t there = std::min<std::uint64_t>({wanted, newest, history_.capacity() - 1});
  std::vector<TickRecord> rows;
  rows.reserve(there);
  TickRecord record;
  for (std::uint64_t number = newest - there + 1; number <= newest; ++number) {
    if (history_.get(number, record)) rows.push_back(record);
  }
  return rows;
}

ServoTiming ServoThread::timing() const {
  return {ticks_, late_ticks_, worst_late_s_, worst_tick_s_, tick_times_.counts(), latenesses_.counts()};
}

void ServoThread::note(double late_s, double tick_s) noexcept {
  constexpr auto relaxed = std::memory_order_relaxed;
  tick_times_.note(tick_s);
  latenesses_.note(late_s);
  if (late_s > 1 / rate_hz_) late_ticks_.store(late_ticks_.load(relaxed) + 1, relaxed);
  if (late_s > worst_late_s_.load(relaxed)) worst_late_s_.store(late_s, relaxed);
  if (tick_s > worst_tick_s_.load(relaxed)) worst_tick_s_.store(tick_s, relaxed);
  ticks_.store(ticks_.load(relaxed) + 1, relaxed);
}

void ServoThread::run(bool real_time, const WarmUp& warm_up) {
  pthread_setname_np(pthread_self(), thread_name);
  sharpen_timers();
  ask_for_short_turns();
  if (real_time) {
    refused_ = run_thread_first();
    for (std::string& line : lock_memory()) refused_.push_back(std::move(line));
  }
  if (warm_up) warm_up();
  ready_ = true;
  ready_.notify_all();  // from here on warm_up may be gone
  loop();
}

void ServoThread::loop() noexcept {
  const long start_ns = now_ns();
  for (long k = 0; !stopping_.load(std::memory_order_relaxed); ++k) {
    const double t_s = static_cast<double>(k) / rate_hz_;
    const long due_ns = start_ns + std::lround(t_s * ns_per_s);
    sleep_until_ns(due_ns);
    const long begun_ns = now_ns();
    history_.put(tick_(t_s));
    note(1e-9 * static_cast<double>(begun_ns - due_ns), 1e-9 * static_cast<double>(now_ns() - begun_ns));
  }
}

}  // namespace fingerpad
