#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <thread>

#include "contact/contact_method_table.hpp"
#include "scene/scene.hpp"
#include "support/allocations.hpp"
#include "support/shapes.hpp"
#include "support/worlds.hpp"
#include "touch/servo_loop.hpp"
#include "touch/touch.hpp"

namespace fingerpad::no_allocation_test {
namespace {

TEST(Allocations, AreCounted) {
  const long of_process = test::allocations_of_process(), of_thread = test::allocations_of_thread();
  const std::vector<double> numbers(100, 1.0);
  void* volatile bytes = std::malloc(100);
  const Eigen::VectorXd sum = Eigen::VectorXd::Constant(50, numbers[0]);
  EXPECT_GE(test::allocations_of_thread() - of_thread, 3) << sum.sum();
  EXPECT_GE(test::allocations_of_process() - of_process, 3);
  std::free(bytes);
}

TEST(Tick, AllocatesNothingWhereItSticksSlipsAndCrossesEdges) {
  const auto world = test::world_of(test::torus_soup(0.05, 0.02, 48, 24));
  std::vector<ContactSettings> contacts;
  for (const ContactMethodEntry& method : contact_method_table()) {
    for (const Normals normals : normals_table()) contacts.push_back({std::string(method.name), normals});
  }
  for (const ContactSettings& contact : contacts) {
    Scene scene = test::plane_scene("finger-pad");
    scene.contact = contact;
    Touch touch(world, scene);
    bool stuck = false, slipped = false;
    const auto sample_at = [](int k) {
      const double across = 1.5 * std::sin(0.004 * k);
      return FingerSample{k * 1e-3, Vec3(0.05 + 0.0195 * std::cos(across), 0, 0.0195 * std::sin(across)),
                          Vec3(0, 0.6, -0.8)};
    };
    touch.warm_up();
    const long before = test::allocations_of_process();
    for (int k = 0; k < 4000; ++k) {
      const Phase phase = touch.tick(sample_at(k)).phase;
      stuck |= phase == Phase::stick;
      slipped |= phase == Phase::slip;
    }
    EXPECT_EQ(test::allocations_of_process() - before, 0);
    EXPECT_TRUE(stuck);
    EXPECT_TRUE(slipped);
  }
}

/// Where the loop's own thread stood when it asked for its first sample, and when its last record was out.
struct ServoCount {
  std::atomic<long> first{-1}, last{-1};
};

TEST(ServoLoop, AllocatesNothingFromItsFirstTickOn) {
  constexpr long ticks = 600;  // more than the history holds, so that old records leave it
  const auto world = test::world_of(test::torus_soup(0.05, 0.02, 48, 24));
  for (const ContactMethodEntry& method : contact_method_table()) {
    Scene scene = test::plane_scene("finger-pad");
    scene.contact.method = method.name;
    scene.motion.rate_hz = 2000;
    ServoCount count;
    scene.parts.emplace_back();
    // Changes of the scene are made ready before: taking them is part of the tick.
    TouchSwap swap(world, scene);
    swap.schedule({{0.05, "part.0.mu_static", "0.6"},
                   {0.1, "friction.law", "stick-slip"},
                   {0.15, "contact.normals", "facet"},
                   {0.2, "contact.method", "closest-point"}});
    ServoLoop loop(
        Touch(world, scene), scene.motion.rate_hz,
        [&count](double t_s) {
          if (t_s == 0) count.first = test::allocations_of_process();
          const double across = 1.5 * std::sin(4 * t_s);
          return FingerSample{t_s, Vec3(0.05 + 0.0195 * std::cos(across), 0, 0.0195 * std::sin(across)),
                              Vec3(0, 0.6, -0.8)};
        },
        [&count, &scene](const TickRecord& record) {
          if (record.t_s >= ticks / scene.motion.rate_hz && count.last < 0)
            count.last = test::allocations_of_process();
        },
        0.1, false, &swap);
    for (int i = 0; i < 1000 && count.last < 0; ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    loop.stop();
    ASSERT_GE(count.last, 0) << "the loop did not get that far";
    EXPECT_EQ(count.last - count.first, 0);
    EXPECT_EQ(swap.taken(0).size(), 4u);
  }
}

}  // namespace
}  // namespace fingerpad::no_allocation_test
