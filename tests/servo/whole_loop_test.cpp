#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <numeric>
#include <thread>

#include "device/pointer_finger.hpp"
#include "support/allocations.hpp"
#include "support/paths.hpp"
#include "support/shapes.hpp"
#include "support/worlds.hpp"
#include "touch/servo_loop.hpp"
#include "trace/hdf5_file.hpp"
#include "trace/live_recorder.hpp"
#include "trace/trace_info.hpp"

// The loop as `touch --record` runs it: the mouse, the touch, the record, the window's readers.

namespace fingerpad::whole_loop_test {
namespace {

constexpr double rate_hz = 2000;

/// Goes over the torus and presses, lifts, and presses again on the other side.
FingerSample pointer_at(double t_s) {
  const double along = 2 * t_s;
  FingerSample target;
  target.t_s = t_s;
  const Vec3 outwards(std::cos(along), std::sin(along), 0);
  const double lift_m = static_cast<int>(t_s / 0.4) % 3 == 0 ? 0.004 : 0;
  target.p_WQ = 0.05 * outwards + (0.02 + lift_m) * Vec3::UnitZ();
  if (lift_m == 0) target.push_W_n = -Vec3::UnitZ();
  return target;
}

TEST(WholeLoop, AllocatesNothingFromItsFirstTickOnAndRecordsHowItKeptItsTime) {
  const auto world = test::world_of(test::torus_soup(0.05, 0.02, 48, 24));
  for (const char* method : {"closest-point", "proxy"}) {
    Scene scene = test::plane_scene("finger-pad");
    scene.contact.method = method;
    scene.motion.rate_hz = rate_hz;
    const std::string path = (test::scratch_dir() / "loop.h5").string();
    LiveRecorder recorder(
        TraceWriter::create(path, TraceFormat::hdf5, trace_info(scene, *world, "0"), *world));
    FingerSample start;
    start.p_WQ = Vec3(0, 0, 0.05);
    PointerFinger finger({scene, world, start});
    finger.look_from(Vec3::UnitZ());
    std::atomic<long> touched{0}, before_first{-1}, allocations{-1};
    ServoLoop loop(
        Touch(world, scene), rate_hz,
        [&](double) {
          if (before_first < 0) before_first = test::allocations_of_thread();
          return finger.advance(1 / rate_hz);
        },
        [&](const TickRecord& record) {
          finger.feel(record);
          recorder.push(record);
          touched += record.walls > 0 ? 1 : 0;
          allocations = test::allocations_of_thread() - before_first;
        },
        0.1, true);
    for (int event = 0; event < 150; ++event) {
      finger.set_target(pointer_at(0.01 * event));
      loop.recent(0.1);
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    loop.stop();
    const ServoTiming timing = loop.timing();
    recorder.note_timing(timing);
    recorder.finish();
    EXPECT_EQ(allocations, 0) << method;
    EXPECT_GT(touched, 200) << method;
    EXPECT_EQ(timing.tick_times.total(), static_cast<std::uint64_t>(timing.ticks));
    EXPECT_GT(timing.tick_times.quantile_s(0.5), 0);
    EXPECT_LE(timing.tick_times.quantile_s(0.5), timing.tick_times.quantile_s(0.999));
    EXPECT_EQ(read_trace(path).rows.size(), static_cast<std::size_t>(timing.ticks));
    const hdf5::Handle file = hdf5::open_file(path);
    EXPECT_EQ(hdf5::read_whole(file, "servo_ticks"), static_cast<std::uint64_t>(timing.ticks));
    EXPECT_EQ(hdf5::read_whole(file, "servo_late_ticks"), static_cast<std::uint64_t>(timing.late_ticks));
    EXPECT_EQ(hdf5::read_numbers(file, "servo_worst_late_s", 1).front(), timing.worst_late_s);
    const auto counts = hdf5::read_numbers(file, "servo_tick_time_counts", TimeCounts::buckets);
    EXPECT_EQ(std::accumulate(counts.begin(), counts.end(), 0.0), static_cast<double>(timing.ticks));
  }
}

}  // namespace
}  // namespace fingerpad::whole_loop_test
