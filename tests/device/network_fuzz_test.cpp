#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <random>
#include <thread>

#include "device/network_device.hpp"

// Fuzzed packets over a true socket, on the true clock. A few thousand; FINGERPAD_FUZZED_PACKETS=1000000
// makes it more.

namespace fingerpad::network_fuzz_test {
namespace {

long packet_count() {
  const char* asked = std::getenv("FINGERPAD_FUZZED_PACKETS");
  return asked != nullptr ? std::atol(asked) : 20'000;
}

/// A packet as a device may send it, or some of its bytes changed, or noise; whole or cut. Its sequence is
/// left as it is, since one far ahead would end all others, and so would an emergency stop all forces.
std::size_t fuzz(PacketBytes& bytes, std::uint32_t sequence, std::mt19937_64& bits) {
  DevicePacket packet;
  packet.sequence = sequence;
  packet.position_m =
      Vec3(1e-5 * static_cast<double>(bits() % 100), 0, -1e-5 * static_cast<double>(bits() % 1000));
  const double half = 1e-3 * static_cast<double>(bits() % 3000);
  packet.orientation_wxyz = {std::cos(half), 0, std::sin(half), 0};
  packet.flags = static_cast<std::uint32_t>(bits() & flag_has_orientation);
  bytes = packet_of(packet);
  const std::uint64_t choice = bits();
  if (choice % 4 == 1)
    for (std::uint64_t n = choice >> 8 & 7; n > 0; --n)
      bytes[8 + bits() % 72] = static_cast<unsigned char>(bits());
  if (choice % 16 == 3)
    for (std::size_t i = 8 * (choice >> 8 & 1); i < 80; ++i) bytes[i] = static_cast<unsigned char>(bits());
  bytes[75] &= 0x7f;
  return (choice >> 16 & 15) == 0 ? choice >> 20 & 63 : 80;
}

struct Wire {
  explicit Wire(const NetworkDevice& device) : socket(::socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK, 0)) {
    to.sin_family = AF_INET;
    to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    to.sin_port =
        htons(static_cast<std::uint16_t>(std::stoi(device.name().substr(device.name().rfind(':') + 1))));
  }
  ~Wire() { close(socket); }
  void send(const PacketBytes& bytes, std::size_t length) {
    sendto(socket, bytes.data(), length, 0, reinterpret_cast<sockaddr*>(&to), sizeof(to));
  }
  bool hear(AnswerPacket& answer) {
    unsigned char buffer[128];
    const ssize_t count = recv(socket, buffer, sizeof(buffer), 0);
    return count > 0 && read_answer({buffer, static_cast<std::size_t>(count)}, answer);
  }
  int socket;
  sockaddr_in to{};
};

/// A tick over a stiff floor at z = 0.
void tick(NetworkDevice& device) {
  TickRecord record;
  const Vec3 p_WQ = device.advance(1e-3).p_WQ;
  ASSERT_TRUE(p_WQ.allFinite());
  if (p_WQ.z() < 0) {
    record.phase = Phase::slip;
    record.normal_W = Vec3::UnitZ();
    record.depth_m = -p_WQ.z();
    record.force_W_n = Vec3(0.3, 0, 1) * 1e4 * record.depth_m;
  }
  device.feel(record);
  ASSERT_LE(device.sent_W_n().norm(), 5);
}

TEST(NetworkFuzz, GivesNoForceThatIsNotFiniteOrAboveTheLimitAndNoneInSilence) {
  Scene scene;
  scene.finger.radius_m = 0.005;
  NetworkDevice device({scene, nullptr, {0, Vec3(0, 0, 0.1), Vec3::UnitY()}, {"127.0.0.1", 0}});
  Wire wire(device);
  std::mt19937_64 bits(3);
  PacketBytes bytes;
  AnswerPacket answer;
  double most_n = 0;
  long answers = 0;
  const long packets = packet_count();
  for (long k = 1; k <= packets; ++k) {
    const std::size_t length = fuzz(bytes, static_cast<std::uint32_t>(k), bits);
    wire.send(bytes, length);
    if (k % 4 != 0) continue;
    tick(device);
    for (; wire.hear(answer); ++answers) {
      ASSERT_TRUE(answer.force_n.allFinite() && answer.torque_n_m.allFinite());
      ASSERT_LE(answer.force_n.norm(), 5);
      most_n = std::max(most_n, answer.force_n.norm());
    }
    if (k % 100 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_GT(answers, packets / 1000);
  EXPECT_GT(most_n, 0.1);
  for (PacketGate::Counts before, now = device.counts(); !(before == now); now = device.counts()) {
    before = now;
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
  }
  tick(device);
  EXPECT_EQ(device.sent_W_n(), Vec3::Zero()) << "nothing has come for 20 ms";
}

}  // namespace
}  // namespace fingerpad::network_fuzz_test
