#pragma once

#include <atomic>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

#include "touch/touch.hpp"

namespace fingerpad {

/// Runs the tick on a thread of its own at a fixed rate, on an absolute clock: a late tick is made up for, so
/// time in the trace is time on the wall. What the ticks say can be read at any moment without holding the
/// thread up. The loop itself allocates nothing from its first tick on.
class ServoLoop {
 public:
  /// Where the finger is at tick time t_s since the start. Called on the servo thread, once a tick.
  using Source = std::function<FingerSample(double t_s)>;
  /// Takes each tick's record, on the servo thread; must neither block, allocate nor throw.
  using Sink = std::function<void(const TickRecord&)>;

  struct Timing {
    long ticks = 0;
    long late_ticks = 0;  ///< started more than one tick after their time
    double worst_late_s = 0;
  };

  /// Starts at once.
  /// @param history_s  how much of the past recent() can give
  ServoLoop(Touch touch, double rate_hz, Source source, Sink sink, double history_s = 10);
  ~ServoLoop();
  ServoLoop(const ServoLoop&) = delete;
  ServoLoop& operator=(const ServoLoop&) = delete;

  /// Ends the thread after the tick under way; nothing more reaches the sink.
  void stop();

  TickRecord latest() const;
  /// The records of the last `seconds`, oldest first.
  std::vector<TickRecord> recent(double seconds) const;
  Timing timing() const;

 private:
  void run();
  void publish(const TickRecord& record) noexcept;
  /// The record that `age` ticks came after. @pre the lock is held, age < kept_
  const TickRecord& kept(std::size_t age) const noexcept;

  Touch touch_;
  double rate_hz_;
  Source source_;
  Sink sink_;
  std::size_t history_ticks_;

  // Guards history_, newest_, kept_ and timing_; the servo thread only ever tries it.
  mutable std::mutex mutex_;
  std::vector<TickRecord> history_;  // a ring of history_ticks_ records
  std::size_t newest_ = 0, kept_ = 0;
  Timing timing_;
  std::vector<TickRecord> unpublished_;  // servo thread only: what a reader's lock kept back
  Timing servo_timing_;                  // servo thread only
  std::atomic<bool> stopping_{false};
  std::thread thread_;
};

}  // namespace fingerpad
