#pragma once

#include <atomic>
#include <condition_variable>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "trace/trace_writer.hpp"

namespace fingerpad {

/// Records a live run: the servo thread pushes its ticks into a ring, a thread of the recorder's own writes
/// them and flushes at least every 0.1 s, so that the servo never waits for the disk.
class LiveRecorder {
 public:
  /// What to do while it records, on the writer's thread.
  struct Watch {
    /// What is wrong with the file's place since it was opened, asked at every flush; empty: nothing.
    std::function<std::string()> place_fault{};
    /// Changes of the scene since the start but for the first `from`, asked for before the rows that were
    /// felt under them are written.
    std::function<std::vector<SceneChange>(std::size_t from)> changes{};
    /// Told once, at once, when the recording can go no further.
    std::function<void(const std::string& why)> tell{};
  };

  /// @param capacity  ticks that the ring holds while the disk is slow
  explicit LiveRecorder(std::unique_ptr<TraceWriter> writer, std::size_t capacity = 1 << 15);
  LiveRecorder(std::unique_ptr<TraceWriter> writer, Watch watch, std::size_t capacity = 1 << 15);
  LiveRecorder(const LiveRecorder&) = delete;
  LiveRecorder& operator=(const LiveRecorder&) = delete;
  /// Finishes; an error is swallowed (call finish() to hear of it).
  ~LiveRecorder();

  /// One producer only. noexcept, never blocks, allocates nothing; a tick that finds the ring full is dropped
  /// and counted.
  void push(const TickRecord& record) noexcept;

  /// How the loop kept its time: said before finish(), written by it.
  void note_timing(const ServoTiming& timing) { timing_ = timing; }

  /// Writes what was pushed, marks the trace complete and joins. Push nothing afterwards. Throws Error
  /// (fault) if the disk refused at any time. A second call does nothing.
  void finish();

  long dropped() const noexcept { return dropped_.load(std::memory_order_relaxed); }
  /// Ticks handed to the writer so far.
  long recorded() const noexcept { return recorded_.load(std::memory_order_relaxed); }
  /// True once the disk has refused: the recording goes no further.
  bool failed() const noexcept { return failed_.load(std::memory_order_acquire); }
  /// Why; empty while it goes on. Any thread.
  const std::string& fault() const noexcept;

 private:
  void run();
  void drain();
  void write();
  void give_up(std::exception_ptr error, const std::string& why);
  void stop();

  std::unique_ptr<TraceWriter> writer_;
  Watch watch_;
  std::optional<ServoTiming> timing_;
  std::vector<TickRecord> ring_;
  std::atomic<std::size_t> pushed_{0},
      taken_{0};  // counts since the start; the ring's places are their remainders
  std::atomic<long> dropped_{0}, recorded_{0};
  std::atomic<bool> failed_{false};
  std::exception_ptr error_;       // writer thread, until it is joined
  std::string fault_;              // writer thread, until failed_ is set; then nobody's to change
  std::vector<TickRecord> batch_;  // writer thread
  std::size_t changes_ = 0;        // writer thread: handed to the writer so far
  std::mutex mutex_;               // guards stopping_
  std::condition_variable wake_;
  bool stopping_ = false;
  std::thread thread_;
};

}  // namespace fingerpad
