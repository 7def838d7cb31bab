#include "device/motor_guard.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

namespace fingerpad::motor_guard_test {
namespace {

constexpr double dt_s = 1e-3;
const Vec3 push_n(0, 0, 3);

/// A guard whose soft start is over.
void warm_up(MotorGuard& guard) {
  for (int k = 0; k < 60; ++k) guard.next(push_n, true, dt_s);
}

TEST(MotorGuard, LetsAnOrdinaryForceThroughBitForBit) {
  MotorGuard guard(DeviceSettings{});
  warm_up(guard);
  const Vec3 wanted_n(0.1, -1.0 / 3, 2.9);
  const auto sent = guard.next(wanted_n, true, dt_s);
  EXPECT_EQ(sent.force_D_n, wanted_n);
  EXPECT_FALSE(sent.limited);
}

TEST(MotorGuard, KeepsTheLimitAndTheDirection) {
  MotorGuard guard(DeviceSettings{});
  warm_up(guard);
  MotorGuard::Sent sent;
  for (int k = 0; k < 20; ++k) sent = guard.next(Vec3(0, 30, 40), true, dt_s);
  EXPECT_TRUE(sent.limited);
  EXPECT_LE(sent.force_D_n.norm(), 5);
  EXPECT_NEAR((sent.force_D_n - Vec3(0, 3, 4)).norm(), 0, 1e-12);
}

TEST(MotorGuard, ChangesNoFasterThanTheRateLimit) {
  DeviceSettings settings;
  settings.force_rate_limit_n_per_s = 100;
  MotorGuard guard(settings);
  warm_up(guard);
  Vec3 last_n = push_n;
  for (const Vec3& wanted_n : {Vec3(4, 0, 0), Vec3(-4, 0, 0), Vec3(0, 4.9, 0)}) {
    for (int k = 0; k < 10; ++k) {
      const auto sent = guard.next(wanted_n, true, dt_s);
      ASSERT_LE((sent.force_D_n - last_n).norm(), 0.1 * (1 + 1e-12));
      ASSERT_TRUE(sent.limited);
      last_n = sent.force_D_n;
    }
  }
}

TEST(MotorGuard, StartsSoftlyAfterEveryLossOfContact) {
  MotorGuard guard(DeviceSettings{});
  for (int contact = 0; contact < 2; ++contact) {
    for (int k = 1; k <= 50; ++k) {
      const auto sent = guard.next(Vec3(0, 0, 5), true, dt_s);
      ASSERT_NEAR(sent.force_D_n.z(), 5 * k / 50.0, 1e-12) << k;  // 5 N over 50 ms
    }
    for (int k = 0; k < 3; ++k) guard.next(Vec3::Zero(), false, dt_s);
  }
}

TEST(MotorGuard, LeavesATapAtAUsualSpeedAsItIs) {
  MotorGuard guard(DeviceSettings{});
  // 0.09 m/s into 1000 N/m: 90 N/s, where the soft start allows 100.
  for (int k = 1; k <= 40; ++k) {
    const Vec3 wanted_n(0, 0, 0.09 * k);
    const auto sent = guard.next(wanted_n, true, dt_s);
    ASSERT_EQ(sent.force_D_n, wanted_n);
    ASSERT_FALSE(sent.limited);
  }
}

TEST(MotorGuard, IsWithoutForceAtOnceWhenReleasedAndThenStartsSoftly) {
  MotorGuard guard(DeviceSettings{});
  warm_up(guard);
  guard.release();
  EXPECT_NEAR(guard.next(push_n, true, dt_s).force_D_n.norm(), 0.1, 1e-12);  // 5 N over 50 ms, one of them
}

TEST(MotorGuard, HoldsNoForceWhileStoppedWhateverIsWanted) {
  MotorGuard guard(DeviceSettings{});
  warm_up(guard);
  guard.set_stopped(true);
  for (int k = 0; k < 100; ++k) {
    const auto sent = guard.next(push_n, k % 7 != 0, dt_s);
    ASSERT_EQ(sent.force_D_n, Vec3::Zero());
  }
  guard.set_stopped(false);
  EXPECT_NEAR(guard.next(push_n, true, dt_s).force_D_n.norm(), 0.1, 1e-12);
}

TEST(MotorGuard, SendsNothingThatIsNotFiniteOrAboveTheLimit) {
  std::mt19937_64 bits(1);
  DeviceSettings settings;
  for (const double limit_n : {5.0, 0.0, 1e-300, 1e3}) {
    settings.force_limit_n = limit_n;
    MotorGuard guard(settings);
    for (int k = 0; k < 50000; ++k) {
      Vec3 wanted_n;
      for (double& part : wanted_n) {  // any bits: huge, tiny, infinite, not a number
        const std::uint64_t raw = bits();
        std::memcpy(&part, &raw, sizeof(part));
      }
      const auto sent = guard.next(wanted_n, bits() % 16 != 0, dt_s);
      ASSERT_TRUE(sent.force_D_n.allFinite());
      ASSERT_LE(sent.force_D_n.norm(), limit_n);
    }
  }
}

}  // namespace
}  // namespace fingerpad::motor_guard_test
