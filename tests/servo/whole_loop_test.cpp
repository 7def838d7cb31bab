#include <gtest/gtest.h>

#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <new>
#include <numeric>
#include <thread>

#include "device/pointer_finger.hpp"
#include "support/paths.hpp"
#include "support/shapes.hpp"
#include "support/worlds.hpp"
#include "touch/servo_loop.hpp"
#include "trace/hdf5_file.hpp"
#include "trace/live_recorder.hpp"
#include "trace/trace_info.hpp"

// The loop as `touch --record` runs it: the mouse, the touch, the record, the window's readers.

namespace {
thread_local bool is_servo = false;
std::atomic<long> allocations{0};

void note_allocation() {
  if (is_servo) ++allocations;
}
}  // namespace

#ifndef __SANITIZE_ADDRESS__  // whose own malloc this would hide
extern "C" {
void* __libc_malloc(std::size_t size);                           // NOLINT: glibc's names
void* __libc_memalign(std::size_t alignment, std::size_t size);  // NOLINT
void* __libc_calloc(std::size_t count, std::size_t size);        // NOLINT
void* malloc(std::size_t size) {
  note_allocation();
  return __libc_malloc(size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
  note_allocation();
  return __libc_memalign(alignment, size);
}
void* calloc(std::size_t count, std::size_t size) {
  note_allocation();
  return __libc_calloc(count, size);
}
int posix_memalign(void** out, std::size_t alignment, std::size_t size) {
  note_allocation();
  *out = __libc_memalign(alignment, size);
  return *out == nullptr ? ENOMEM : 0;
}
}
#endif

// Not inlined: where g++ 12 inlines only one of a pair, it warns of a mismatch that is none.
[[gnu::noinline]] void* operator new(std::size_t size) {
  note_allocation();
  if (void* p = std::malloc(size)) return p;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* p) noexcept {
  std::free(p);
}
[[gnu::noinline]] void operator delete(void* p, std::size_t) noexcept {
  std::free(p);
}

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
    allocations = 0;
    std::atomic<long> touched{0};
    ServoLoop loop(
        Touch(world, scene), rate_hz,
        [&](double) {
          is_servo = true;
          return finger.advance(1 / rate_hz);
        },
        [&](const TickRecord& record) {
          finger.feel(record);
          recorder.push(record);
          touched += record.walls > 0 ? 1 : 0;
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
