#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "touch/record_ring.hpp"
#include "touch/time_histogram.hpp"

namespace fingerpad {

/// A thread that ticks at a fixed rate, on an absolute clock: a late tick is made up for, so time in the
/// trace is time on the wall. What the ticks say and how they keep their time can be read at any moment; the
/// thread waits for nobody. From its first tick on the loop allocates nothing, locks nothing, and reads and
/// writes no file.
class ServoThread {
 public:
  /// The tick at t_s since the start. On the thread; must neither block, allocate nor throw.
  using Tick = std::function<TickRecord(double t_s)>;

  /// What is to be set up on the thread before its first tick; it may allocate, and must not throw.
  using WarmUp = std::function<void()>;

  /// As the system's tools show it (top -H).
  static constexpr const char* thread_name = "fingerpad-servo";

  /// Starts at once; the first tick comes when warm_up has ended.
  /// @param history_s  how much of the past recent() can give
  /// @param real_time  asks for what the system keeps for such loops, and goes on without where it refuses
  /// @param warm_up  may be empty
  ServoThread(double rate_hz, Tick tick, double history_s, bool real_time, WarmUp warm_up = {});
  ~ServoThread();
  ServoThread(const ServoThread&) = delete;
  ServoThread& operator=(const ServoThread&) = delete;

  /// Ends the thread after the tick under way.
  void stop();

  /// A line for each thing that real_time asked for and the system refused.
  const std::vector<std::string>& refused() const noexcept { return refused_; }

  TickRecord latest() const;
  /// The records of the last `seconds`, oldest first. Where the thread overtakes the reader, fewer.
  std::vector<TickRecord> recent(double seconds) const;
  ServoTiming timing() const;

 private:
  void run(bool real_time, const WarmUp& warm_up);
  void loop() noexcept;
  void note(double late_s, double tick_s) noexcept;

  double rate_hz_;
  Tick tick_;
  RecordRing history_;
  // Written by the thread alone.
  std::atomic<long> ticks_{0}, late_ticks_{0};
  std::atomic<double> worst_late_s_{0}, worst_tick_s_{0};
  TimeHistogram tick_times_, latenesses_;

  std::vector<std::string> refused_;
  std::atomic<bool> ready_{false}, stopping_{false};
  std::thread thread_;
};

}  // namespace fingerpad
