#include "trace/live_recorder.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "base/error.hpp"

namespace fingerpad {
namespace {

// Half of what the contract allows between flushes, since a flush takes time itself.
constexpr std::chrono::milliseconds flush_interval{50};

}  // namespace

LiveRecorder::LiveRecorder(std::unique_ptr<TraceWriter> writer, std::size_t capacity)
    : LiveRecorder(std::move(writer), Watch{}, capacity) {}

LiveRecorder::LiveRecorder(std::unique_ptr<TraceWriter> writer, Watch watch, std::size_t capacity)
    : writer_(std::move(writer)), watch_(std::move(watch)), ring_(std::max<std::size_t>(capacity, 1)) {
  batch_.reserve(ring_.size());
  thread_ = std::thread([this] { run(); });
}

LiveRecorder::~LiveRecorder() {
  try {
    finish();
  } catch (...) {  // NOLINT(bugprone-empty-catch): told by finish() to whoever asks
  }
}

void LiveRecorder::push(const TickRecord& record) noexcept {
  const std::size_t pushed = pushed_.load(std::memory_order_relaxed);
  if (pushed - taken_.load(std::memory_order_acquire) == ring_.size()) {
    dropped_.fetch_add(1, std::memory_order_relaxed);
    return;
  }
  ring_[pushed % ring_.size()] = record;
  pushed_.store(pushed + 1, std::memory_order_release);
}

/// Takes everything from the ring, so that it never fills once the disk has refused, and writes what can be
/// written.
void LiveRecorder::drain() {
  const std::size_t pushed = pushed_.load(std::memory_order_acquire);
  std::size_t taken = taken_.load(std::memory_order_relaxed);
  batch_.clear();
  for (; taken != pushed; ++taken) batch_.push_back(ring_[taken % ring_.size()]);
  taken_.store(taken, std::memory_order_release);
  if (!batch_.empty() && !failed()) write();
}

/// A touch goes on whatever becomes of its record: no error of the disk leaves this thread.
void LiveRecorder::write() {
  try {
    if (watch_.changes) {
      const std::vector<SceneChange> changes = watch_.changes(changes_);
      writer_->note_changes(changes);
      changes_ += changes.size();
    }
    writer_->append(batch_);
    writer_->flush();
  } catch (const std::exception& error) {
    give_up(std::current_exception(), error.what());
    return;
  }
  const std::string fault = watch_.place_fault ? watch_.place_fault() : std::string();
  if (fault.empty()) {
    recorded_.fetch_add(static_cast<long>(batch_.size()), std::memory_order_relaxed);
  } else {
    give_up(std::make_exception_ptr(Error(ErrorKind::fault, "", fault)), fault);
  }
}

void LiveRecorder::give_up(std::exception_ptr error, const std::string& why) {
  error_ = std::move(error);
  fault_ = why;
  failed_.store(true, std::memory_order_release);
  if (watch_.tell) watch_.tell(why);
}

const std::string& LiveRecorder::fault() const noexcept {
  static const std::string none;
  return failed() ? fault_ : none;
}

void LiveRecorder::run() {
  std::unique_lock lock(mutex_);
  while (!stopping_) {
    wake_.wait_for(lock, flush_interval, [this] { return stopping_; });
    lock.unlock();
    drain();
    lock.lock();
  }
}

void LiveRecorder::stop() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  wake_.notify_all();
  thread_.join();
}

void LiveRecorder::finish() {
  if (!thread_.joinable()) return;
  stop();
  drain();
  const std::unique_ptr<TraceWriter> writer = std::move(writer_);
  if (error_) std::rethrow_exception(error_);
  if (timing_) writer->note_timing(*timing_);
  writer->finish();
}

}  // namespace fingerpad
