#include "touch/servo_loop.hpp"

#include <algorithm>
#include <chrono>

namespace fingerpad {

ServoLoop::ServoLoop(Touch touch, double rate_hz, Source source, Sink sink, double history_s)
    : touch_(std::move(touch)),
      rate_hz_(rate_hz),
      source_(std::move(source)),
      sink_(std::move(sink)),
      history_ticks_(std::max<std::size_t>(1, static_cast<std::size_t>(history_s * rate_hz))) {
  unpublished_.reserve(history_ticks_);
  thread_ = std::thread([this] { run(); });
}

ServoLoop::~ServoLoop() {
  stop();
}

void ServoLoop::stop() {
  stopping_ = true;
  if (thread_.joinable()) thread_.join();
}

TickRecord ServoLoop::latest() const {
  const std::lock_guard lock(mutex_);
  return history_.empty() ? TickRecord{} : history_.back();
}

std::vector<TickRecord> ServoLoop::recent(double seconds) const {
  const std::lock_guard lock(mutex_);
  const auto wanted = std::min(history_.size(), static_cast<std::size_t>(std::max(0.0, seconds * rate_hz_)));
  return {history_.end() - static_cast<std::ptrdiff_t>(wanted), history_.end()};
}

ServoLoop::Timing ServoLoop::timing() const {
  const std::lock_guard lock(mutex_);
  return timing_;
}

void ServoLoop::publish(const TickRecord& record) {
  if (unpublished_.size() < history_ticks_) unpublished_.push_back(record);
  const std::unique_lock lock(mutex_, std::try_to_lock);
  if (!lock.owns_lock()) return;  // a reader is copying: the next tick brings this one along
  history_.insert(history_.end(), unpublished_.begin(), unpublished_.end());
  unpublished_.clear();
  while (history_.size() > history_ticks_) history_.pop_front();
  timing_ = servo_timing_;
}

void ServoLoop::run() {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  for (long k = 0; !stopping_; ++k) {
    const double t_s = static_cast<double>(k) / rate_hz_;
    const auto due = start + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(t_s));
    std::this_thread::sleep_until(due);
    const double late_s = std::chrono::duration<double>(Clock::now() - due).count();
    servo_timing_.ticks = k + 1;
    servo_timing_.late_ticks += late_s > 1 / rate_hz_ ? 1 : 0;
    servo_timing_.worst_late_s = std::max(servo_timing_.worst_late_s, late_s);
    FingerSample sample = source_(t_s);
    sample.t_s = t_s;
    const TickRecord record = touch_.tick(sample);
    sink_(record);
    publish(record);
  }
}

}  // namespace fingerpad
