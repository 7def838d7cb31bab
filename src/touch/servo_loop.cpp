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
  history_.resize(history_ticks_);
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

const TickRecord& ServoLoop::kept(std::size_t age) const noexcept {
  return history_[(newest_ + history_ticks_ - age) % history_ticks_];
}

TickRecord ServoLoop::latest() const {
  const std::lock_guard lock(mutex_);
  return kept_ == 0 ? TickRecord{} : kept(0);
}

std::vector<TickRecord> ServoLoop::recent(double seconds) const {
  const std::lock_guard lock(mutex_);
  const auto wanted = std::min(kept_, static_cast<std::size_t>(std::max(0.0, seconds * rate_hz_)));
  std::vector<TickRecord> rows;
  rows.reserve(wanted);
  for (std::size_t age = wanted; age-- > 0;) rows.push_back(kept(age));
  return rows;
}

ServoLoop::Timing ServoLoop::timing() const {
  const std::lock_guard lock(mutex_);
  return timing_;
}

void ServoLoop::publish(const TickRecord& record) noexcept {
  if (unpublished_.size() < history_ticks_) unpublished_.push_back(record);
  const std::unique_lock lock(mutex_, std::try_to_lock);
  if (!lock.owns_lock()) return;  // a reader is copying: the next tick brings this one along
  for (const TickRecord& row : unpublished_) {
    newest_ = (newest_ + 1) % history_ticks_;
    history_[newest_] = row;
  }
  kept_ = std::min(kept_ + unpublished_.size(), history_ticks_);
  unpublished_.clear();
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
