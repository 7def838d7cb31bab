#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <memory>
#include <new>
#include <string_view>

#include "device/device_table.hpp"

namespace {
thread_local long allocations_here = 0;
}

#ifndef __SANITIZE_ADDRESS__  // which tells what a library made by another new apart from what this one made
// Not inlined: where g++ 12 inlines only one of a pair, it warns of a mismatch that is none.
[[gnu::noinline]] void* operator new(std::size_t size) {
  ++allocations_here;
  if (void* p = std::malloc(size)) return p;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* p) noexcept {
  std::free(p);
}
[[gnu::noinline]] void operator delete(void* p, std::size_t) noexcept {
  std::free(p);
}
#endif

namespace fingerpad::servo_side_test {
namespace {

TEST(ServoSide, OfADeviceAllocatesNothing) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "allocations are counted without the sanitizer";
#endif
  Scene scene;
  scene.motion.scripted.emplace();
  for (const std::string_view name : {"network", "recorded", "hand"}) {
    const FingerSample start{0, Vec3::UnitZ(), Vec3::UnitY()};
    const auto device = find_device(name)->make({scene, nullptr, start, {"127.0.0.1", 0}});
    TickRecord tick;
    tick.phase = Phase::slip;
    tick.normal_W = Vec3::UnitZ();
    tick.force_W_n = Vec3(1, 0, 1e9);
    device->set_target(start);
    const long before = allocations_here;
    for (int k = 0; k < 100; ++k) {
      tick.p_WQ = device->advance(1e-3).p_WQ;
      device->feel(tick);
    }
    EXPECT_EQ(allocations_here, before) << name;
  }
}

}  // namespace
}  // namespace fingerpad::servo_side_test
