// Built with -fsanitize=thread, with the servo loop's own sources and what other threads share with it: the
// window's readers, the mouse's events, the recorder's disk. Ends 66 where two threads touch the same memory.

#include <atomic>
#include <chrono>
#include <cstdio>
#include <thread>

#include "device/pointer_path.hpp"
#include "touch/servo_thread.hpp"
#include "trace/live_recorder.hpp"

namespace {

using namespace fingerpad;

class CountingWriter final : public TraceWriter {
 public:
  explicit CountingWriter(std::atomic<long>& rows) : rows_(rows) {}
  void append(std::span<const TickRecord> rows) override { rows_ += static_cast<long>(rows.size()); }
  void flush() override {}
  FileSum finish() override { return {}; }

 private:
  std::atomic<long>& rows_;
};

/// A record whose every number is that of its tick: a torn one shows.
TickRecord record_at(double t_s, const Vec3& p_W) {
  TickRecord record;
  record.t_s = record.depth_m = record.normal_force_n = record.inclination_rad = t_s;
  record.p_WQ = p_W;
  return record;
}

bool is_whole(const TickRecord& record) {
  return record.depth_m == record.t_s && record.normal_force_n == record.t_s;
}

/// How many of the records that a reader got from the smallest ring were torn, as fast as a writer writes.
long torn_in_haste() {
  RecordRing ring(2);
  std::atomic<bool> ends{false};
  std::thread writer([&] {
    for (long k = 1; !ends; ++k) ring.put(record_at(static_cast<double>(k), Vec3::Zero()));
  });
  long torn = 0;
  TickRecord record;
  for (int got = 0; got < 20000;) {
    if (!ring.get(ring.count(), record)) continue;
    ++got;
    torn += is_whole(record) ? 0 : 1;
  }
  ends = true;
  writer.join();
  return torn;
}

}  // namespace

int main() {
  std::atomic<long> written{0};
  LiveRecorder recorder(std::make_unique<CountingWriter>(written), 64);
  PointerPath path({});
  long torn = torn_in_haste(), reads = 0;
  {
    ServoThread servo(
        20000,
        [&](double t_s) {
          const TickRecord record = record_at(t_s, path.advance(5e-5).finger.p_WQ);
          recorder.push(record);
          return record;
        },
        0, false);  // the smallest ring, which the reader reads to its last place
    PointerAim aim;
    const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(600);
    while (std::chrono::steady_clock::now() < end) {
      aim.finger.t_s += 1e-4;
      path.put(aim);
      if (servo.timing().ticks > 0 && !is_whole(servo.latest())) ++torn;
      for (const TickRecord& record : servo.recent(1)) torn += is_whole(record) ? 0 : 1;
      ++reads;
    }
  }
  recorder.finish();
  std::printf("%ld reads, %ld records torn, %ld written\n", reads, torn, written.load());
  return torn == 0 && reads > 10 && written > 100 ? 0 : 1;
}
