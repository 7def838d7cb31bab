#include "device/network_device.hpp"

#include <fmt/format.h>
#include <poll.h>

#include "device/device_table.hpp"

namespace fingerpad {
namespace {

constexpr int network_port = 47110;

DeviceReading reading_of(const DevicePacket& packet, std::int64_t now_ns, std::uint64_t accepted) noexcept {
  DeviceReading reading;
  reading.place.p_D = packet.position_m;
  if ((packet.flags & flag_has_orientation) != 0) {
    const auto& q = packet.orientation_wxyz;
    reading.place.attitude_D = Attitude(q[0], q[1], q[2], q[3]).normalized();
  }
  reading.place.clutch = (packet.buttons & button_clutch) != 0;
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

}  // namespace

NetworkDevice::NetworkDevice(const DeviceSetup& setup, DeviceClock clock)
    : clock_(clock),
      finger_(setup.scene.device, setup.start, setup.scene.finger.radius_m),
      socket_(setup.link.bind, setup.link.port.value_or(network_port)) {
  thread_ = std::thread([this] { run(); });
}

NetworkDevice::~NetworkDevice() {
  stop();
}

void NetworkDevice::stop() {
  stopping_ = true;
  wake_up_.wake();
  if (thread_.joinable()) thread_.join();
}

FingerSample NetworkDevice::advance(double dt_s) {
  DeviceReading reading;
  if (readings_.take(reading)) finger_.hear(reading);
  return finger_.advance(clock_(), dt_s);
}

void NetworkDevice::feel(const TickRecord& tick) noexcept {
  const bool is_first = finger_.heard() != heard_;
  const DeviceAnswer answer = finger_.feel(tick, clock_(), is_first);
  if (!is_first) return;  // nothing has come since the last answer
  heard_ = finger_.heard();
  answers_.put(answer);
  wake_up_.wake();
}

void NetworkDevice::run() {
  while (!stopping_) {
    pollfd ready[] = {{socket_.descriptor(), POLLIN, 0}, {wake_up_.descriptor(), POLLIN, 0}};
    if (poll(ready, 2, -1) < 0) continue;  // a signal
    if (ready[1].revents != 0) {
      wake_up_.clear();
      answer();
    }
    if (ready[0].revents != 0) receive();
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
    const std::int64_t now_ns = clock_();
    const std::span<const unsigned char> bytes(buffer, static_cast<std::size_t>(count));
    const PacketSender before = gate_.sender();
    if (!gate_.pass(bytes, sender, now_ns, packet)) continue;
    // What is still owed to a sender who has gone silent is not told to another.
    if (!(sender == before)) answered_ = gate_.counts().accepted - 1;
    // At once: a reading may be replaced by the next before the servo sees it.
    if ((packet.buttons & button_emergency_stop) != 0) finger_.guard().set_stopped(true);
    readings_.put(reading_of(packet, now_ns, gate_.counts().accepted));
  }
  counted_.put(gate_.counts());
}

/// One answer for each packet that was accepted before the tick.
void NetworkDevice::answer() noexcept {
  answers_.take(newest_);
  if (finger_.guard().stopped()) {  // also where the stop has come since that tick
    newest_.force_D_n = newest_.torque_D_n_m = Vec3::Zero();
    newest_.stopped = true;
  }
  for (; answered_ < newest_.accepted; ++answered_) {
    socket_.send(packet_of(packet_for(newest_, ++answer_sequence_)), gate_.sender());
    newest_.watchdog_tripped = false;  // told, and only once
  }
}

PacketGate::Counts NetworkDevice::counts() noexcept {
  counted_.take(counts_);
  return counts_;
}

std::string NetworkDevice::opening_words() const {
  return fmt::format("listening for a device on {}, UDP", name());
}

std::string NetworkDevice::closing_words() {
  stop();
  return counts_text(gate_.counts());
}

DeviceEntry network_device() noexcept {
  return {.name = "network",
          .doc = "any device, by packets over UDP (--port, --bind)",
          .make = [](const DeviceSetup& setup) -> std::unique_ptr<LiveDevice> {
            return std::make_unique<NetworkDevice>(setup);
          }};
}

}  // namespace fingerpad
