#pragma once

#include "touch/servo_thread.hpp"
#include "touch/touch.hpp"
#include "touch/touch_swap.hpp"

namespace fingerpad {

/// Runs a touch on a thread of its own (ServoThread): each tick takes the finger's place from the source, and
/// what it felt goes to the sink.
class ServoLoop {
 public:
  /// Where the finger is at tick time t_s since the start. Called on the servo thread, once a tick.
  using Source = std::function<FingerSample(double t_s)>;
  /// Takes each tick's record, on the servo thread; must neither block, allocate nor throw.
  using Sink = std::function<void(const TickRecord&)>;
  using Timing = ServoTiming;

  /// Starts at once; see ServoThread.
  /// @param swap  changes the touch between ticks; outlives this; may be null
  ServoLoop(Touch touch, double rate_hz, Source source, Sink sink, double history_s = 10,
            bool real_time = false, TouchSwap* swap = nullptr)
      : touch_(std::move(touch)),
        swap_(swap),
        source_(std::move(source)),
        sink_(std::move(sink)),
        thread_(
            rate_hz, [this](double t_s) { return tick(t_s); }, history_s, real_time,
            [this] { touch_.warm_up(); }) {}

  /// Ends the thread after the tick under way; nothing more reaches the sink.
  void stop() { thread_.stop(); }
  const std::vector<std::string>& refused() const noexcept { return thread_.refused(); }
  TickRecord latest() const { return thread_.latest(); }
  std::vector<TickRecord> recent(double seconds) const { return thread_.recent(seconds); }
  Timing timing() const { return thread_.timing(); }

 private:
  TickRecord tick(double t_s) {
    if (swap_ != nullptr) swap_->before_tick(touch_, t_s);
    FingerSample sample = source_(t_s);
    sample.t_s = t_s;
    const TickRecord record = touch_.tick(sample);
    sink_(record);
    return record;
  }

  Touch touch_;
  TouchSwap* swap_;
  Source source_;
  Sink sink_;
  ServoThread thread_;  // last: it ends before what it uses
};

}  // namespace fingerpad
