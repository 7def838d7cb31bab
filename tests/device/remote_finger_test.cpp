#include "device/remote_finger.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "device/network_device.hpp"

namespace fingerpad::remote_finger_test {
namespace {

const FingerSample rest{0, Vec3(0, 0, 0.1), Vec3(0, 0.6, -0.8)};
constexpr std::int64_t ms = 1'000'000;

/// A device on a clock of the test's own, at 1000 ticks a second, over a floor at z = 0 of 1000 N/m.
struct Rig {
  explicit Rig(const DeviceSettings& settings = {}) : finger(settings, rest) {}

  void say(const Vec3& p_D, bool clutch = false) {
    DevicePlace place;
    place.p_D = p_D;
    place.clutch = clutch;
    say(place);
  }
  void say(const DevicePlace& place) {
    DeviceReading reading;
    reading.place = place;
    reading.arrived_ns = now_ns;
    reading.sequence = ++sequence;
    reading.accepted = sequence;
    finger.hear(reading);
  }
  DeviceAnswer tick(bool is_sent = true) {
    sample = finger.advance(now_ns, 1e-3);
    TickRecord record;
    record.p_WQ = sample.p_WQ;
    if (sample.p_WQ.z() < 0) {
      record.phase = Phase::stick;
      record.depth_m = -sample.p_WQ.z();
      record.force_W_n = Vec3(0, 0, 1000 * record.depth_m);
      record.torque_W_n_m = Vec3(record.depth_m, 0, 0);
      record.normal_W = Vec3::UnitZ();
    }
    const DeviceAnswer answer = finger.feel(record, now_ns, is_sent);
    now_ns += ms;
    return answer;
  }

  RemoteFinger finger;
  FingerSample sample;
  std::int64_t now_ns = 5 * ms;
  std::uint32_t sequence = 0;
};

TEST(RemoteFinger, RestsUntilTheDeviceSpeaks) {
  Rig rig;
  EXPECT_EQ(rig.tick().force_D_n, Vec3::Zero());
  EXPECT_EQ(rig.sample.p_WQ, rest.p_WQ);
  rig.say({0.01, 0, 0.02});
  const DeviceAnswer answer = rig.tick();
  EXPECT_EQ(rig.sample.p_WQ, Vec3(0.01, 0, 0.02));
  EXPECT_FALSE(answer.watchdog_tripped) << "a device that was never there has not gone silent";
}

TEST(RemoteFinger, LiftsASilentDevicesFingerWithin20MsAndThenStartsSoftly) {
  Rig rig;
  for (int k = 0; k < 100; ++k) {
    rig.say({0, 0, -0.002});
    rig.tick();
  }
  const std::int64_t last_heard_ns = rig.now_ns - ms;
  while (rig.now_ns < last_heard_ns + 20 * ms) ASSERT_NEAR(rig.tick(false).force_D_n.z(), 2, 1e-12);
  DeviceAnswer answer = rig.tick(false);  // 20 ms of silence
  EXPECT_EQ(answer.force_D_n, Vec3::Zero());
  EXPECT_EQ(rig.sample.p_WQ, rest.p_WQ);
  EXPECT_EQ(answer.phase, Phase::free);
  rig.say({0, 0, -0.002});
  answer = rig.tick();
  EXPECT_TRUE(answer.watchdog_tripped);
  EXPECT_TRUE(answer.limited);
  EXPECT_NEAR(answer.force_D_n.z(), 0.1, 1e-12);  // 5 N over 50 ms, the first of them
  rig.say({0, 0, -0.002});
  EXPECT_FALSE(rig.tick().watchdog_tripped) << "it was told";
}

TEST(RemoteFinger, IsWithoutForceFromAnEmergencyStopUntilItIsTakenBack) {
  Rig rig;
  for (int k = 0; k < 200; ++k) {
    if (k == 100) rig.finger.guard().set_stopped(true);
    rig.say({0, 0, -0.002});
    const DeviceAnswer answer = rig.tick();
    ASSERT_EQ(answer.stopped, k >= 100);
    if (k >= 100) {
      ASSERT_EQ(answer.force_D_n, Vec3::Zero()) << k;
    }
  }
  rig.finger.guard().set_stopped(false);
  rig.say({0, 0, -0.002});
  EXPECT_NEAR(rig.tick().force_D_n.z(), 0.1, 1e-12);
}

TEST(RemoteFinger, ABurstOfTicksMovesTheForceNoFasterThanTheClock) {
  Rig rig;
  for (int k = 0; k < 100; ++k) {
    rig.say({0, 0, -0.001});
    rig.tick();
  }
  rig.say({0, 0, -0.005});
  for (int k = 0; k < 50; ++k) {
    rig.now_ns -= ms;  // the clock stands still
    ASSERT_NEAR(rig.tick().force_D_n.z(), 1, 1e-3);
  }
  EXPECT_NEAR(rig.tick().force_D_n.z(), 3, 1e-3);  // 2000 N/s for a millisecond
}

TEST(RemoteFinger, ClutchingMovesTheDeviceWithoutTheFingerAndWithoutForce) {
  Rig rig;
  for (int k = 0; k < 60; ++k) {
    rig.say({0, 0, -0.003});
    rig.tick();
  }
  for (int k = 0; k <= 10; ++k) {
    rig.say({0.01 * k, 0, -0.003}, true);
    ASSERT_EQ(rig.tick().force_D_n, Vec3::Zero());
    ASSERT_NEAR((rig.sample.p_WQ - Vec3(0, 0, -0.003)).norm(), 0, 1e-15);
  }
  rig.say({0.1, 0, -0.003});
  rig.tick();
  EXPECT_NEAR((rig.sample.p_WQ - Vec3(0, 0, -0.003)).norm(), 0, 1e-15);
  rig.say({0.11, 0, -0.003});
  rig.tick();
  EXPECT_NEAR((rig.sample.p_WQ - Vec3(0.01, 0, -0.003)).norm(), 0, 1e-15);  // sums of a few decimals
}

Attitude turned_by(double angle_rad, const Vec3& axis) {
  const double half = angle_rad / 2;
  return {std::cos(half), std::sin(half) * axis.x(), std::sin(half) * axis.y(), std::sin(half) * axis.z()};
}

TEST(RemoteFinger, ClutchingTurnsTheDeviceWithoutTheFinger) {
  Workspace workspace({}, rest);
  DevicePlace place;
  place.attitude_D = turned_by(0.4, Vec3::UnitZ());
  const FingerSample before = workspace.finger(place);
  ASSERT_TRUE(before.attitude);
  place.clutch = true;
  for (int k = 0; k <= 10; ++k) {
    place.attitude_D = turned_by(0.4 - 0.2 * k, Vec3(0.6, 0, 0.8));
    const FingerSample held = workspace.finger(place);
    ASSERT_EQ(held.direction_W, before.direction_W);
    ASSERT_EQ(held.attitude->coeffs(), before.attitude->coeffs());
  }
  place.clutch = false;
  for (int k = 0; k < 2; ++k) {  // the tick that lets go, and the next
    const FingerSample gone_on = workspace.finger(place);
    EXPECT_NEAR((gone_on.direction_W - before.direction_W).norm(), 0, 1e-15);
    EXPECT_NEAR(gone_on.attitude->angularDistance(*before.attitude), 0,
                1e-7);  // the root of a rounding error
  }
  // A turn of the device about an axis is then one of the finger about the same.
  place.attitude_D = turned_by(0.3, Vec3::UnitX()) * *place.attitude_D;
  const Vec3 wanted_W = turned_by(0.3, Vec3::UnitX()) * before.direction_W;
  EXPECT_NEAR((workspace.finger(place).direction_W - wanted_W).norm(), 0, 1e-15);
}

TEST(RemoteFinger, LiesInTheWorldAsTheSceneSays) {
  DeviceSettings settings;
  settings.rotation << 0, -1, 0, 1, 0, 0, 0, 0, 1;  // the device's x is the world's y
  settings.scale = 2;
  settings.offset_m = Vec3(0, 0, -0.5);
  settings.force_scale = 0.5;
  settings.soft_start_s = 0;
  settings.force_rate_limit_n_per_s = 1e9;
  Workspace workspace(settings, rest);
  DevicePlace place;
  place.p_D = Vec3(0.125, 0, 0.25);
  EXPECT_EQ(workspace.finger(place).p_WQ, Vec3(0, 0.25, 0));
  EXPECT_EQ(workspace.force_D_n(Vec3(0, 4, 2)), Vec3(2, 0, 1));
  EXPECT_FALSE(workspace.finger(place).attitude);
  // A quarter turn about the device's x is one about the world's y.
  place.attitude_D = Attitude(std::sqrt(0.5), std::sqrt(0.5), 0, 0);
  const FingerSample turned = workspace.finger(place);
  const Vec3 wanted(-0.8, 0.6, 0);
  EXPECT_NEAR((turned.direction_W - wanted).norm(), 0, 1e-15);
}

TEST(RemoteFinger, LimitsATorqueByAsMuchAsTheForceAndScalesItsArm) {
  DeviceSettings settings;
  settings.rotation << 0, -1, 0, 1, 0, 0, 0, 0, 1;  // the world's x is the device's -y
  settings.scale = 4;
  settings.force_scale = 0.5;
  settings.soft_start_s = 0;
  settings.force_rate_limit_n_per_s = 1e9;
  Rig rig(settings);
  rig.say({0, 0, -0.001});  // 4 N, of which it is shown 2, and 4 mN m
  EXPECT_NEAR((rig.tick().torque_D_n_m - Vec3(0, -0.004 * 0.5 / 4, 0)).norm(), 0, 1e-15);
  rig.say({0, 0, -0.005});  // 20 N, of which it would be shown 10 and is shown 5
  const DeviceAnswer limited = rig.tick();
  EXPECT_TRUE(limited.limited);
  EXPECT_NEAR((limited.torque_D_n_m - Vec3(0, -0.020 * 0.25 / 4, 0)).norm(), 0, 1e-15);
}

TEST(RemoteFinger, TellsTheDepthAsTheDeviceMeasures) {
  DeviceSettings settings;
  settings.scale = 4;
  Rig rig(settings);
  rig.say({0, 0, -0.001});
  EXPECT_EQ(rig.tick().depth_m, 0.001);
  EXPECT_EQ(rig.sample.p_WQ.z(), -0.004);
}

TEST(RemoteFinger, AMillionHostilePacketsGiveNoForceThatIsNotFiniteOrAboveTheLimit) {
  std::mt19937_64 bits(7);
  Rig rig;
  PacketGate gate;
  const PacketSender sender{{1}, 16};
  PacketBytes last = packet_of(DevicePacket{});
  DevicePacket packet;
  std::uint32_t sequence = 0;
  std::int64_t heard_ns = 0;
  long turned = 0, silent = 0;
  for (int k = 0; k < 1'000'000; ++k) {
    DevicePacket said;
    said.sequence = ++sequence;
    said.position_m = Vec3(0, 0, -1e-5 * static_cast<double>(bits() % 1000));
    const double half = 1e-3 * static_cast<double>(bits() % 3000);
    said.orientation_wxyz = {std::cos(half), 0, std::sin(half), 0};
    said.flags = static_cast<std::uint32_t>(bits() & flag_has_orientation);
    PacketBytes bytes = packet_of(said);
    // One of: as it is, some bytes changed, the last one again, noise; whole or cut.
    const std::uint64_t choice = bits();
    if (choice % 4 == 1)
      for (std::uint64_t n = choice >> 8 & 7; n > 0; --n)
        bytes[bits() % 80] = static_cast<unsigned char>(bits());
    if (choice % 4 == 2) bytes = last;
    if (choice % 4 == 3)
      for (std::size_t i = choice >> 8 & 4; i < 80; ++i) bytes[i] = static_cast<unsigned char>(bits());
    last = bytes;
    const std::size_t length = (choice >> 16 & 15) == 0 ? choice >> 20 & 63 : 80;
    const bool passed = gate.pass(std::span(bytes).first(length), sender, rig.now_ns, packet);
    if (passed) rig.say(place_of(packet));
    if (passed) heard_ns = rig.now_ns;
    turned += passed && (packet.flags & flag_has_orientation) != 0 ? 1 : 0;
    if (passed && gate.counts().accepted % 1000 == 0) rig.now_ns += 25 * ms;  // silence
    const DeviceAnswer answer = rig.tick(passed);
    ASSERT_TRUE(answer.force_D_n.allFinite());
    ASSERT_LE(answer.force_D_n.norm(), 5);
    ASSERT_TRUE(answer.torque_D_n_m.allFinite());
    ASSERT_TRUE(rig.sample.direction_W.allFinite());
    if (rig.finger.lifted() || rig.now_ns - ms - heard_ns >= 20 * ms) {
      ASSERT_EQ(answer.force_D_n, Vec3::Zero());
      ++silent;
    }
    sequence = passed ? packet.sequence : sequence;
  }
  EXPECT_GT(turned, 100'000);
  EXPECT_GT(silent, 100);
  EXPECT_GT(gate.counts().accepted, 250'000u);
  EXPECT_GT(gate.counts().malformed, 100'000u);
  EXPECT_GT(gate.counts().numbers, 1000u);
  EXPECT_GT(gate.counts().old, 10'000u);
  EXPECT_EQ(gate.counts().accepted + gate.counts().dropped(), 1'000'000u);
}

}  // namespace
}  // namespace fingerpad::remote_finger_test
