#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <pty.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <thread>

#include "device/device_packet.hpp"
#include "device/device_table.hpp"
#include "support/allocations.hpp"
#include "support/paths.hpp"
#include "support/worlds.hpp"

namespace fingerpad::servo_side_test {
namespace {

/// Makes a device and ticks it; something is said to it before each tick. @returns what the ticks allocated
template <typename Say>
long allocations_of(const DeviceEntry& entry, const DeviceLink& link, const Say& say) {
  Scene scene = test::plane_scene("none");
  scene.motion.scripted.emplace();
  const FingerSample start{0, Vec3(0, 0, 0.02), Vec3::UnitY()};
  const auto device = entry.make({scene, test::plane_world(), start, link});
  TickRecord tick;
  tick.phase = Phase::slip;
  tick.normal_W = Vec3::UnitZ();
  tick.force_W_n = Vec3(1, 0, 1e9);
  FingerSample target = start;
  long allocations = 0;
  for (int k = 0; k < 100; ++k) {
    target.p_WQ.x() = 1e-4 * k;
    target.t_s = 0.008 * k;
    device->set_target(target);
    say(*device);
    const long before = test::allocations_of_thread();
    tick.p_WQ = device->advance(1e-3).p_WQ;
    device->feel(tick);
    // Embree sets up per-thread memory on a thread's first query.
    if (k > 9) allocations += test::allocations_of_thread() - before;
  }
  return allocations;
}

constexpr auto nothing = [](LiveDevice&) {};

/// Each tick finds a packet that has come; some answers are sent.
long with_packets(const DeviceEntry& entry) {
  const int other = socket(AF_INET, SOCK_DGRAM, 0);
  DevicePacket packet;
  const long allocations = allocations_of(entry, {"127.0.0.1", 0}, [&](const LiveDevice& device) {
    const std::string words = device.opening_words();
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    to.sin_port = htons(static_cast<std::uint16_t>(std::stoi(words.substr(words.find("127.0.0.1:") + 10))));
    ++packet.sequence;
    packet.position_m.z() = -1e-4 * packet.sequence;
    const PacketBytes bytes = packet_of(packet);
    sendto(other, bytes.data(), bytes.size(), 0, reinterpret_cast<sockaddr*>(&to), sizeof(to));
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  });
  close(other);
  return allocations;
}

long with_fake_service(const DeviceEntry& entry) {
  const std::string service = (test::source_dir() / "tests" / "support" / "fake_inverse_service").string();
  std::FILE* const said = popen(("echo $$; exec '" + service + "'").c_str(), "r");
  char process[64] = "", port[64] = "";
  if (said == nullptr || std::fgets(process, 64, said) == nullptr || std::fgets(port, 64, said) == nullptr)
    return -1;
  const long allocations = allocations_of(entry, {{}, std::atoi(port)}, [](LiveDevice&) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  });
  kill(std::atoi(process), SIGTERM);
  pclose(said);
  return allocations;
}

/// A daemon that lets anyone in and says nothing.
long with_daemon(const DeviceEntry& entry) {
  const std::string path = (test::scratch_dir() / "s").string();
  const int listener = socket(AF_UNIX, SOCK_STREAM, 0);
  sockaddr_un at{};
  at.sun_family = AF_UNIX;
  path.copy(at.sun_path, sizeof(at.sun_path) - 1);
  if (bind(listener, reinterpret_cast<sockaddr*>(&at), sizeof(at)) != 0 || listen(listener, 1) != 0)
    return -1;
  setenv("SPNAV_SOCKET", path.c_str(), 1);
  const long allocations = allocations_of(entry, {}, nothing);
  unsetenv("SPNAV_SOCKET");
  close(listener);
  return allocations;
}

/// In a process that has a terminal of its own.
long with_terminal(const DeviceEntry& entry) {
  int master = -1;
  const pid_t child = forkpty(&master, nullptr, nullptr, nullptr);
  if (child == 0) _exit(allocations_of(entry, {}, nothing) == 0 ? 0 : 1);
  char typed[] = "\x1b[A\x1b[C";
  if (write(master, typed, sizeof(typed) - 1) < 0) return -1;
  int status = -1;
  waitpid(child, &status, 0);
  close(master);
  return status;
}

TEST(ServoSide, OfEveryDeviceAllocatesNothing) {
  for (const DeviceEntry& entry : device_table()) {
    long allocations = -1;
    if (entry.name == "network") {
      allocations = with_packets(entry);
    } else if (entry.name == "haply") {
      allocations = with_fake_service(entry);
    } else if (entry.name == "spacemouse") {
      allocations = with_daemon(entry);
    } else if (entry.name == "keyboard") {
      allocations = with_terminal(entry);
    } else {
      allocations = allocations_of(entry, {}, nothing);
    }
    EXPECT_EQ(allocations, 0) << entry.name;
  }
}

}  // namespace
}  // namespace fingerpad::servo_side_test
