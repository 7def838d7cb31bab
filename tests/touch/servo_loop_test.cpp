#include "touch/servo_loop.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "support/worlds.hpp"

namespace fingerpad::servo_loop_test {
namespace {

TEST(ServoLoop, TicksAtItsRateAndKeepsEveryRecordInOrder) {
  std::vector<double> sunk;
  ServoLoop loop(
      Touch(test::plane_world(), test::plane_scene("finger-pad")), 1000,
      [](double t_s) {
        FingerSample sample;
        sample.p_WQ = Vec3(0.1 * t_s, 0, -0.001);
        return sample;
      },
      [&sunk](const TickRecord& record) { sunk.push_back(record.t_s); });
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  for (int i = 0; i < 200; ++i) loop.recent(0.1);  // a reader in the way must lose nothing
  loop.stop();
  ASSERT_GT(sunk.size(), 100u);
  for (std::size_t k = 0; k < sunk.size(); ++k) ASSERT_DOUBLE_EQ(sunk[k], static_cast<double>(k) * 1e-3);
  const auto rows = loop.recent(10);
  for (std::size_t k = 1; k < rows.size(); ++k) ASSERT_NEAR(rows[k].t_s - rows[k - 1].t_s, 1e-3, 1e-12);
  EXPECT_NEAR(loop.latest().normal_force_n, 1, 1e-12);
  EXPECT_LE(loop.timing().ticks, static_cast<long>(sunk.size()));
  EXPECT_GE(loop.timing().ticks, static_cast<long>(sunk.size()) - 1);
}

TEST(ServoLoop, StopsAtOnceAndTwice) {
  std::atomic<long> ticks{0};
  ServoLoop loop(
      Touch(test::plane_world(), test::plane_scene("none")), 1000,
      [](double t_s) {
        return FingerSample{t_s, Vec3::Zero(), Vec3::UnitY()};
      },
      [&ticks](const TickRecord&) { ++ticks; });
  loop.stop();
  const long after = ticks;
  loop.stop();
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_EQ(ticks, after);
}

}  // namespace
}  // namespace fingerpad::servo_loop_test
