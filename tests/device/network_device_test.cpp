#include "device/network_device.hpp"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <optional>
#include <thread>

#include "base/error.hpp"

namespace fingerpad::network_device_test {
namespace {

/// The clock of a test, which stands still until it is told.
std::atomic<std::int64_t> test_clock_ns{1'000'000'000};

/// The other end: a stranger's socket.
class Peer {
 public:
  explicit Peer(const NetworkDevice& device) : socket_(socket(AF_INET, SOCK_DGRAM, 0)) {
    to_.sin_family = AF_INET;
    to_.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    const std::string& name = device.name();
    to_.sin_port = htons(static_cast<std::uint16_t>(std::stoi(name.substr(name.rfind(':') + 1))));
  }
  ~Peer() { close(socket_); }
  void send(std::span<const unsigned char> bytes) {
    ASSERT_EQ(sendto(socket_, bytes.data(), bytes.size(), 0, reinterpret_cast<sockaddr*>(&to_), sizeof(to_)),
              static_cast<ssize_t>(bytes.size()));
  }
  void say(std::uint32_t sequence, const Vec3& position_m, std::uint32_t buttons = 0) {
    DevicePacket packet;
    packet.sequence = sequence;
    packet.position_m = position_m;
    packet.buttons = buttons;
    send(packet_of(packet));
  }
  std::optional<AnswerPacket> hear(int patience_ms) {
    pollfd ready{socket_, POLLIN, 0};
    if (poll(&ready, 1, patience_ms) != 1) return std::nullopt;
    unsigned char buffer[200];
    const ssize_t count = recv(socket_, buffer, sizeof(buffer), 0);
    AnswerPacket answer;
    if (count < 0 || !read_answer({buffer, static_cast<std::size_t>(count)}, answer)) return std::nullopt;
    return answer;
  }

 private:
  int socket_;
  sockaddr_in to_{};
};

constexpr int long_ms = 20'000;  // for a machine that is busy; what comes ends the wait

struct Rig {
  Rig() {
    scene.device.soft_start_s = 0;
    device.emplace(setup(), [] { return test_clock_ns.load(); });
  }
  DeviceSetup setup() const {
    return {scene, nullptr, {0, Vec3(0, 0, 0.1), Vec3::UnitY()}, {"127.0.0.1", 0}};
  }
  /// Ticks over a floor of 1000 N/m at z = 0 when so many packets have come in all.
  FingerSample tick_after(std::uint64_t packets) {
    while (device->counts().accepted + device->counts().dropped() < packets)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    test_clock_ns += 1'000'000;
    const FingerSample sample = device->advance(1e-3);
    TickRecord record;
    if (sample.p_WQ.z() < 0) {
      record.phase = Phase::slip;
      record.depth_m = -sample.p_WQ.z();
      record.force_W_n = Vec3(0.25, 0, 1000 * record.depth_m);
    }
    device->feel(record);
    return sample;
  }

  Scene scene;
  std::optional<NetworkDevice> device;
};

TEST(NetworkDevice, AnswersEachAcceptedPacketOnceAfterTheNextTick) {
  Rig rig;
  Peer peer(*rig.device);
  peer.say(41, {0, 0, -0.001});
  peer.say(42, {0, 0, -0.0015});
  peer.say(42, {0, 0, -0.9});
  EXPECT_EQ(rig.tick_after(3).p_WQ, Vec3(0, 0, -0.0015));
  for (std::uint32_t k = 1; k <= 2; ++k) {
    const auto answer = peer.hear(long_ms);
    ASSERT_TRUE(answer);
    EXPECT_EQ(answer->sequence, k);
    EXPECT_EQ(answer->accepted_sequence, 42u);
    EXPECT_EQ(answer->status, status_touching | status_slip);
    EXPECT_EQ(answer->clock_ns, static_cast<std::uint64_t>(test_clock_ns.load()));
    EXPECT_EQ(answer->force_n, Vec3(0.25, 0, 1.5));
    EXPECT_EQ(answer->depth_m, 0.0015);
  }
  rig.tick_after(3);  // nothing was said since: no answer
  peer.say(43, {0, 0, 0.01});
  rig.tick_after(4);
  const auto answer = peer.hear(long_ms);
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->sequence, 3u);
  EXPECT_EQ(answer->accepted_sequence, 43u);
  EXPECT_EQ(answer->status, 0u);
  EXPECT_EQ(rig.device->closing_words(), "3 packets accepted, 1 dropped: 1 old or repeated");
}

TEST(NetworkDevice, SaysThatNobodyIsHeardAndWhereItListens) {
  Rig rig;
  Peer peer(*rig.device);
  const std::string at = rig.device->name() + " (UDP)";
  EXPECT_EQ(rig.device->trouble(), "no device yet: nothing heard on " + at);
  peer.say(0, {0, 0, 0.01});
  rig.tick_after(1);
  EXPECT_EQ(rig.device->trouble(), "no device yet: what came to " + at + " was not in the protocol");
  peer.say(1, {0, 0, 0.01});
  rig.tick_after(2);
  EXPECT_EQ(rig.device->trouble(), "");
  test_clock_ns += 18'000'000;  // a millisecond more has passed at the tick
  EXPECT_EQ(rig.device->trouble(), "");
  test_clock_ns += 1'000'000;
  EXPECT_EQ(rig.device->trouble(), "no packet on " + at + " for 20 ms: finger lifted");
  peer.say(2, {0, 0, 0.01});
  rig.tick_after(3);
  EXPECT_EQ(rig.device->trouble(), "");
}

TEST(NetworkDevice, KeepsTellingOfASilenceForASecondAndOfTooFewPacketsForAsLongAsTheyAre) {
  Rig rig;
  Peer peer(*rig.device);
  const std::string none = "no packet on " + rig.device->name() + " (UDP) for 20 ms";
  std::uint32_t sent = 0;
  const auto say = [&] {
    peer.say(++sent, {0, 0, 0.01});
    rig.tick_after(sent);
  };
  const auto fall_silent = [&] {
    test_clock_ns += 25'000'000;
    rig.tick_after(sent);
  };
  say();
  fall_silent();
  EXPECT_EQ(rig.device->trouble(), none + ": finger lifted");
  say();
  EXPECT_EQ(rig.device->trouble(), none + ": finger was lifted") << "for a person to read";
  test_clock_ns += 1'000'000'000;
  say();
  EXPECT_EQ(rig.device->trouble(), "");
  for (int k = 0; k < 5; ++k) {
    fall_silent();
    const std::string words = rig.device->trouble();
    say();
    if (k == 0) continue;
    EXPECT_EQ(words, none + ": finger lifted, again and again");
    EXPECT_EQ(rig.device->trouble(), words) << "the same, or it would flicker";
  }
  EXPECT_EQ(rig.device->closing_words(),
            "8 packets accepted, 0 dropped; no packet for 20 ms lifted the finger 6 times: the device sends "
            "too seldom (or watchdog_s in [device] is too short)");
}

TEST(NetworkDevice, TellsThatTheWatchdogHasTrippedAndStopsByTheBit) {
  Rig rig;
  Peer peer(*rig.device);
  peer.say(1, {0, 0, -0.001});
  rig.tick_after(1);
  ASSERT_TRUE(peer.hear(long_ms));
  test_clock_ns += 19'000'000;
  EXPECT_EQ(rig.tick_after(1).p_WQ, Vec3(0, 0, 0.1)) << "lifted";
  EXPECT_EQ(rig.device->sent_W_n(), Vec3::Zero());
  peer.say(2, {0, 0, -0.001});
  rig.tick_after(2);
  auto answer = peer.hear(long_ms);
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->status, status_touching | status_slip | status_watchdog);
  peer.say(3, {0, 0, -0.001}, button_emergency_stop);
  peer.say(4, {0, 0, -0.001});
  rig.tick_after(4);
  for (int k = 0; k < 2; ++k) answer = peer.hear(long_ms);
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->force_n, Vec3::Zero());
  EXPECT_TRUE(answer->status & status_stopped) << "though a packet without the bit came before the tick";
  EXPECT_TRUE(rig.device->closing_words().ends_with("; the emergency stop was on at the end: no force"));
}

TEST(NetworkDevice, TellsOfATripOnceThoughItAnswersTwice) {
  Rig rig;
  Peer peer(*rig.device);
  peer.say(1, {0, 0, -0.001});
  rig.tick_after(1);
  ASSERT_TRUE(peer.hear(long_ms));
  test_clock_ns += 25'000'000;
  rig.tick_after(1);
  peer.say(2, {0, 0, -0.001});
  peer.say(3, {0, 0, -0.001});
  rig.tick_after(3);
  const auto first = peer.hear(long_ms), second = peer.hear(long_ms);
  ASSERT_TRUE(first && second);
  EXPECT_EQ(first->status & status_watchdog, status_watchdog);
  EXPECT_EQ(second->status & status_watchdog, 0u);
}

/// A device whose thread does nothing: its side is the test's.
class QuietDevice final : public RemoteDevice {
 public:
  explicit QuietDevice(const DeviceSetup& setup)
      : RemoteDevice(setup, Answers::to_readings, [] { return test_clock_ns.load(); }) {}
  ~QuietDevice() override { stop(); }
  using RemoteDevice::hand_over;
  using RemoteDevice::newest_answer;

 private:
  void run() override {}
};

TEST(RemoteDevice, SendsNoForceOfATickBeforeAStopThatWasAccepted) {
  Scene scene;
  scene.device.soft_start_s = 0;
  QuietDevice device({scene, nullptr, {0, Vec3(0, 0, 0.1), Vec3::UnitY()}});
  DeviceReading reading;
  reading.place.p_D = Vec3(0, 0, -0.001);
  reading.arrived_ns = test_clock_ns;
  reading.accepted = 1;
  device.hand_over(reading);
  device.advance(1e-3);
  TickRecord tick;
  tick.phase = Phase::slip;
  tick.normal_W = Vec3::UnitZ();
  tick.force_W_n = Vec3(0, 0, 1);
  test_clock_ns += 1'000'000;
  device.feel(tick);
  EXPECT_EQ(device.newest_answer().force_D_n, Vec3(0, 0, 1));
  device.set_emergency_stop(true);
  EXPECT_EQ(device.newest_answer().force_D_n, Vec3::Zero());
  EXPECT_TRUE(device.newest_answer().stopped);
}

TEST(NetworkDevice, IsNotShakenByNoise) {
  Rig rig;
  Peer peer(*rig.device);
  std::vector<unsigned char> noise(2000, 0xff);
  for (const std::size_t length : {0u, 1u, 79u, 80u, 81u, 2000u}) peer.send(std::span(noise).first(length));
  PacketBytes good = packet_of(DevicePacket{.sequence = 5});
  std::copy(good.begin(), good.end(), noise.begin());
  peer.send(std::span(noise).first(81));
  peer.say(1, {0, 0, 0.05});
  EXPECT_EQ(rig.tick_after(8).p_WQ, Vec3(0, 0, 0.05));
  EXPECT_EQ(rig.device->counts(), (PacketGate::Counts{.accepted = 1, .malformed = 7}));
}

TEST(NetworkDevice, TellsWhoCannotListen) {
  Rig rig;
  DeviceSetup setup = rig.setup();
  const std::string name = rig.device->name();
  setup.link.port = std::stoi(name.substr(name.rfind(':') + 1));
  EXPECT_THROW(NetworkDevice{setup}, Error) << "the port is taken";
  setup.link = {"localhost", 0};
  EXPECT_THROW(NetworkDevice{setup}, Error) << "no numbers";
  setup.link = {"203.0.113.7", 0};
  EXPECT_THROW(NetworkDevice{setup}, Error) << "not of this machine";
}

}  // namespace
}  // namespace fingerpad::network_device_test
