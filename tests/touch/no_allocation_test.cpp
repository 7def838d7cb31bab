#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <cstdlib>
#include <new>

#include "support/shapes.hpp"
#include "support/worlds.hpp"
#include "touch/touch.hpp"

namespace {
std::atomic<long> allocations{0};
}

// Not inlined: where g++ 12 inlines only one of a pair, it warns of a mismatch that is none.
[[gnu::noinline]] void* operator new(std::size_t size) {
  ++allocations;
  if (void* p = std::malloc(size)) return p;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* p) noexcept {
  std::free(p);
}
[[gnu::noinline]] void operator delete(void* p, std::size_t) noexcept {
  std::free(p);
}

namespace fingerpad {
namespace {

TEST(Tick, AllocatesNothingWhereItSticksSlipsAndCrossesEdges) {
  const auto world = test::world_of(test::torus_soup(0.05, 0.02, 48, 24));
  const std::pair<ContactMethod, Normals> contacts[] = {{ContactMethod::closest_point, Normals::smooth},
                                                        {ContactMethod::closest_point, Normals::curved},
                                                        {ContactMethod::proxy, Normals::smooth},
                                                        {ContactMethod::proxy, Normals::curved}};
  for (const auto& [method, normals] : contacts) {
    Scene scene = test::plane_scene("finger-pad");
    scene.contact.method = method;
    scene.contact.normals = normals;
    scene.contact.automatic_normals = false;
    Touch touch(world, scene);
    bool stuck = false, slipped = false;
    const auto sample_at = [](int k) {
      const double across = 1.5 * std::sin(0.004 * k);
      return FingerSample{k * 1e-3, Vec3(0.05 + 0.0195 * std::cos(across), 0, 0.0195 * std::sin(across)),
                          Vec3(0, 0.6, -0.8)};
    };
    for (int k = 0; k < 10; ++k)
      touch.tick(sample_at(k));  // Embree sets up per-thread memory on a thread's first query
    const long before = allocations;
    for (int k = 10; k < 4000; ++k) {
      const Phase phase = touch.tick(sample_at(k)).phase;
      stuck |= phase == Phase::stick;
      slipped |= phase == Phase::slip;
    }
    EXPECT_EQ(allocations - before, 0);
    EXPECT_TRUE(stuck);
    EXPECT_TRUE(slipped);
  }
}

}  // namespace
}  // namespace fingerpad
