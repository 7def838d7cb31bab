#include "device/device_packet.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "device/packet_gate.hpp"

namespace fingerpad::device_packet_test {
namespace {

/// A packet written out by hand, as a stranger's program would.
std::vector<unsigned char> bytes_of(const std::string& magic, const std::vector<unsigned char>& numbers) {
  std::vector<unsigned char> bytes;
  for (const char letter : magic) bytes.push_back(static_cast<unsigned char>(letter));
  for (const unsigned char number : numbers) bytes.push_back(number);
  return bytes;
}

void append_double(std::vector<unsigned char>& bytes, double value) {
  unsigned char raw[8];
  std::memcpy(raw, &value, 8);  // this machine is little-endian
  for (const unsigned char byte : raw) bytes.push_back(byte);
}

TEST(DevicePacket, IsLaidOutAsDocumented) {
  std::vector<unsigned char> numbers = {0x04, 0x03, 0x02, 0x01, 8, 7, 6, 5, 4, 3, 2, 1};
  for (const double value : {0.25, -1.5, 1000.0, 0.5, -0.5, 0.5, -0.5}) append_double(numbers, value);
  for (const int byte : {1, 0, 0, 0x80, 1, 0, 0, 0}) numbers.push_back(static_cast<unsigned char>(byte));
  const auto bytes = bytes_of("FPD1", numbers);
  ASSERT_EQ(bytes.size(), 80u);
  DevicePacket packet;
  ASSERT_EQ(read_packet(bytes, packet), PacketFault::none);
  EXPECT_EQ(packet.sequence, 0x01020304u);
  EXPECT_EQ(packet.clock_ns, 0x0102030405060708u);
  EXPECT_EQ(packet.position_m, Vec3(0.25, -1.5, 1000));
  EXPECT_EQ(packet.orientation_wxyz, (std::array<double, 4>{0.5, -0.5, 0.5, -0.5}));
  EXPECT_EQ(packet.buttons, button_clutch | button_emergency_stop);
  EXPECT_EQ(packet.flags, flag_has_orientation);
  const PacketBytes again = packet_of(packet);
  EXPECT_TRUE(std::equal(again.begin(), again.end(), bytes.begin(), bytes.end()));
}

TEST(DevicePacket, AnswersAreLaidOutAsDocumented) {
  AnswerPacket answer;
  answer.sequence = 0x0a;
  answer.accepted_sequence = 0x01020304;
  answer.status = status_touching | status_slip | status_watchdog;
  answer.clock_ns = 0x1122334455667788;
  answer.force_n = {1, 2, 3};
  answer.torque_n_m = {4, 5, 6};
  answer.depth_m = 7;
  std::vector<unsigned char> numbers{0x0a, 0, 0, 0, 4, 3, 2, 1, 0x15, 0, 0, 0};
  for (const int byte : {0x88, 0x77, 0x66, 0x55, 0x44, 0x33, 0x22, 0x11})
    numbers.push_back(static_cast<unsigned char>(byte));
  for (int value = 1; value <= 7; ++value) append_double(numbers, value);
  const auto bytes = bytes_of("FPF1", numbers);
  const PacketBytes written = packet_of(answer);
  EXPECT_TRUE(std::equal(written.begin(), written.end(), bytes.begin(), bytes.end()));
  AnswerPacket read;
  ASSERT_TRUE(read_answer(written, read));
  EXPECT_EQ(read.torque_n_m, answer.torque_n_m);
  EXPECT_EQ(read.depth_m, 7);
  EXPECT_FALSE(read_answer(packet_of(DevicePacket{}), read));
}

TEST(DevicePacket, TakesOtherLengthsAndMagicForMalformed) {
  const PacketBytes good = packet_of(DevicePacket{});
  DevicePacket packet;
  const std::span<const unsigned char> bytes(good);
  EXPECT_EQ(read_packet(bytes, packet), PacketFault::none);
  EXPECT_EQ(read_packet(bytes.first(79), packet), PacketFault::malformed);
  EXPECT_EQ(read_packet({}, packet), PacketFault::malformed);
  std::array<unsigned char, 81> longer{};
  std::copy(good.begin(), good.end(), longer.begin());
  EXPECT_EQ(read_packet(longer, packet), PacketFault::malformed);
  PacketBytes other = good;
  other[3] = '2';
  EXPECT_EQ(read_packet(other, packet), PacketFault::malformed);
}

TEST(DevicePacket, TakesNoNumberThatIsNotFiniteTooFarOrNoTurn) {
  const auto fault = [](const DevicePacket& packet) {
    DevicePacket read;
    return read_packet(packet_of(packet), read);
  };
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1000.1, -1e300}) {
    for (int axis = 0; axis < 3; ++axis) {
      DevicePacket packet;
      packet.position_m[axis] = bad;
      EXPECT_EQ(fault(packet), PacketFault::numbers) << bad;
    }
  }
  for (std::size_t k = 0; k < 4; ++k) {
    DevicePacket packet;
    packet.orientation_wxyz[k] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(fault(packet), PacketFault::numbers) << "also where it is not given";
    packet.flags = flag_has_orientation;
    packet.orientation_wxyz = {0, 0, 0, 0};
    packet.orientation_wxyz[k] = 1.0009;
    EXPECT_EQ(fault(packet), PacketFault::none);
    packet.orientation_wxyz[k] = -1.0011;
    EXPECT_EQ(fault(packet), PacketFault::numbers);
    packet.flags = 0;
    EXPECT_EQ(fault(packet), PacketFault::none) << "an orientation that is not given need be no turn";
  }
}

TEST(PacketSequence, GoesRoundAsSerialNumbersDo) {
  EXPECT_TRUE(comes_after(2, 1));
  EXPECT_FALSE(comes_after(1, 1));
  EXPECT_FALSE(comes_after(1, 2));
  EXPECT_TRUE(comes_after(0, 0xffffffff));
  EXPECT_TRUE(comes_after(5, 0xfffffff0));
  EXPECT_FALSE(comes_after(0xfffffff0, 5));
  EXPECT_TRUE(comes_after(0x80000000, 1));
  EXPECT_FALSE(comes_after(0x80000001, 1));  // half of them away: neither is after the other
  EXPECT_FALSE(comes_after(1, 0x80000001));
}

/// Packets of one place that differ in their sequence.
struct Gate {
  PacketGate gate;
  PacketSender first{{1}, 16}, second{{2}, 16};
  bool pass(const PacketSender& sender, std::uint32_t sequence, double at_s) {
    DevicePacket packet, read;
    packet.sequence = sequence;
    return gate.pass(packet_of(packet), sender, static_cast<std::int64_t>(1e9 * at_s), read);
  }
};

TEST(PacketGate, DropsAndCountsWhatIsOldOrRepeated) {
  Gate g;
  EXPECT_TRUE(g.pass(g.first, 7, 0));
  EXPECT_FALSE(g.pass(g.first, 7, 0.001));
  EXPECT_FALSE(g.pass(g.first, 6, 0.002));
  EXPECT_TRUE(g.pass(g.first, 9, 0.003)) << "a lost packet is no fault of the next";
  EXPECT_FALSE(g.pass(g.first, 8, 0.004));
  EXPECT_FALSE(g.pass(g.first, 9, 10)) << "a replay after a long silence";
  EXPECT_EQ(g.gate.counts(), (PacketGate::Counts{.accepted = 2, .old = 4}));
}

TEST(PacketGate, HearsOneSenderUntilItHasBeenSilentForASecond) {
  Gate g;
  EXPECT_TRUE(g.pass(g.first, 100, 0));
  EXPECT_FALSE(g.pass(g.second, 200, 0.5));
  EXPECT_TRUE(g.pass(g.first, 101, 0.9));
  EXPECT_FALSE(g.pass(g.second, 201, 1.89));
  EXPECT_TRUE(g.pass(g.second, 1, 1.9)) << "it counts as it likes";
  EXPECT_FALSE(g.pass(g.first, 102, 1.95));
  EXPECT_EQ(g.gate.counts(), (PacketGate::Counts{.accepted = 3, .other = 3}));
  EXPECT_EQ(counts_text(g.gate.counts()), "3 packets accepted, 3 dropped: 3 of another sender");
}

TEST(PacketGate, HearsADeviceThatHasStartedAnewOnItsOwnPortAfterASecond) {
  Gate g;
  EXPECT_TRUE(g.pass(g.first, 5000, 0));
  EXPECT_FALSE(g.pass(g.first, 1, 0.5)) << "old, for all that is known";
  EXPECT_TRUE(g.pass(g.first, 500, 1.0));
  EXPECT_FALSE(g.pass(g.first, 499, 1.1)) << "from there on it counts as ever";
  EXPECT_TRUE(g.pass(g.first, 501, 1.2));
  EXPECT_EQ(g.gate.counts(), (PacketGate::Counts{.accepted = 3, .old = 2}));
}

TEST(PacketGate, HearsNoSequenceZero) {
  Gate g;
  EXPECT_FALSE(g.pass(g.first, 0, 0)) << "they go from 1";
  EXPECT_TRUE(g.pass(g.first, 0xffffffffu, 0));
  EXPECT_TRUE(g.pass(g.first, 1, 0.1));
  EXPECT_EQ(g.gate.counts(), (PacketGate::Counts{.accepted = 2, .old = 1}));
}

}  // namespace
}  // namespace fingerpad::device_packet_test
