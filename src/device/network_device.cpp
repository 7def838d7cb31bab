#include "device/network_device.hpp"

#include <fmt/format.h>

#include "device/device_table.hpp"

namespace fingerpad {
namespace {

constexpr int network_port = 47110;
constexpr const char* local_address = "127.0.0.1";  // none from outside, unless asked for

DeviceReading reading_of(const DevicePacket& packet, std::int64_t now_ns, std::uint64_t accepted) noexcept {
  DeviceReading reading;
  reading.place = place_of(packet);
  reading.arrived_ns = now_ns;
  reading.sequence = packet.sequence;
  reading.accepted = accepted;
  return reading;
}

AnswerPacket packet_for(const DeviceAnswer& answer, std::uint32_t sequence) noexcept {
  AnswerPacket packet;
  packet.sequence = sequence;
  packet.accepted_sequence = answer.sequence;
  packet.status = (answer.phase != Phase::free ? status_touching : 0u) |
                  (answer.phase == Phase::stick ? status_stick : 0u) |
                  (answer.phase == Phase::slip ? status_slip : 0u) | (answer.limited ? status_limited : 0u) |
                  (answer.watchdog_tripped ? status_watchdog : 0u) | (answer.stopped ? status_stopped : 0u);
  packet.clock_ns = static_cast<std::uint64_t>(answer.made_ns);
  packet.force_n = answer.force_D_n;
  packet.torque_n_m = answer.torque_D_n_m;
  packet.depth_m = answer.depth_m;
  return packet;
}

UdpSocket socket_for(const DeviceLink& link) {
  return UdpSocket(link.bind.value_or(local_address), link.port.value_or(network_port));
}

}  // namespace

DevicePlace place_of(const DevicePacket& packet) noexcept {
  DevicePlace place;
  place.p_D = packet.position_m;
  if ((packet.flags & flag_has_orientation) != 0) {
    const auto& q = packet.orientation_wxyz;
    place.attitude_D = Attitude(q[0], q[1], q[2], q[3]).normalized();
  }
  place.clutch = (packet.buttons & button_clutch) != 0;
  return place;
}

NetworkDevice::NetworkDevice(const DeviceSetup& setup, DeviceClock clock)
    : RemoteDevice(setup, Answers::to_readings, clock), socket_(socket_for(setup.link)) {
  start();
}

void NetworkDevice::run() {
  while (!is_stopping()) {
    const WakeUp::Woken woken = wake_up().wait_with(socket_.descriptor());
    if (woken.broken) return;
    if (woken.by_wake) {
      wake_up().clear();
      answer();
    }
    if (woken.by_other) receive();
  }
}

void NetworkDevice::receive() noexcept {
  unsigned char buffer[packet_bytes + 1];  // one more tells a packet that is too long
  PacketSender sender;
  DevicePacket packet;
  constexpr int most_at_once = 64;  // then the answers have their turn
  for (int k = 0; k < most_at_once; ++k) {
    const long count = socket_.receive(buffer, sender);
    if (count < 0) break;
    const std::int64_t now = now_ns();
    const std::span<const unsigned char> bytes(buffer, static_cast<std::size_t>(count));
    const PacketSender before = gate_.sender();
    if (!gate_.pass(bytes, sender, now, packet)) {
      dropped_.store(true, std::memory_order_relaxed);
      continue;
    }
    heard_ns_.store(now, std::memory_order_relaxed);
    // What is still owed to a sender who has gone silent is not told to another.
    if (!(sender == before)) answered_ = gate_.counts().accepted - 1;
    // At once: a reading may be replaced by the next before the servo sees it.
    if ((packet.buttons & button_emergency_stop) != 0) set_emergency_stop(true);
    hand_over(reading_of(packet, now, gate_.counts().accepted));
  }
  counted_.put(gate_.counts());
}

/// One answer for each packet that was accepted before the tick.
void NetworkDevice::answer() noexcept {
  DeviceAnswer& newest = newest_answer();
  for (; answered_ < newest.accepted; ++answered_) {
    socket_.send(packet_of(packet_for(newest, ++answer_sequence_)), gate_.sender());
    newest.watchdog_tripped = false;  // told, and only once
  }
}

PacketGate::Counts NetworkDevice::counts() noexcept {
  counted_.take(counts_);
  return counts_;
}

std::string NetworkDevice::trouble() const {
  const std::int64_t heard_ns = heard_ns_.load(std::memory_order_relaxed);
  if (heard_ns >= 0) {
    const bool is_silent = 1e-9 * static_cast<double>(now_ns() - heard_ns) >= watchdog_s();
    return silence_words(fmt::format("packet on {} (UDP)", name()), is_silent);
  }
  if (dropped_.load(std::memory_order_relaxed))
    return fmt::format("no device yet: what came to {} (UDP) was not in the protocol", name());
  return fmt::format("no device yet: nothing heard on {} (UDP)", name());
}

std::string NetworkDevice::opening_words() const {
  return fmt::format("listening for a device on {}, UDP", name());
}

std::string NetworkDevice::closing_words() {
  stop();
  return counts_text(gate_.counts()) + trips_words(trips(), "packet", gate_.counts().accepted, watchdog_s()) +
         stop_words();
}

DeviceEntry network_device() noexcept {
  return {.name = "network",
          .doc = "any device, by packets over UDP (--port, --bind)",
          .make = [](const DeviceSetup& setup) -> std::unique_ptr<LiveDevice> {
            return std::make_unique<NetworkDevice>(setup);
          },
          .takes_port = true,
          .takes_bind = true,
          .reads_settings = true,
          .refuse = [](const Scene&, const DeviceLink& link) { const UdpSocket refuses = socket_for(link); }};
}

}  // namespace fingerpad
