#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "device/haply_message.hpp"
#include "device/network_device.hpp"
#include "fuzz/entries.hpp"
#include "fuzz/promise.hpp"

namespace fingerpad::test {
namespace {

constexpr std::int64_t device_tick_ns = 1'000'000;

/// A finger over a stiff floor, moved by whatever a device says.
class HostileDevice {
 public:
  void say(const DevicePlace& place) {
    DeviceReading reading;
    reading.place = place;
    reading.arrived_ns = now_ns_;
    reading.accepted = ++said_;
    finger_.hear(reading);
  }
  void tick() {
    now_ns_ += device_tick_ns;
    TickRecord tick;
    const FingerSample sample = finger_.advance(now_ns_, 1e-9 * device_tick_ns);
    tick.p_WQ = sample.p_WQ;
    promise(tick.p_WQ.allFinite(), "the finger is somewhere");
    promise(std::abs(sample.direction_W.norm() - 1) < 1e-6, "it points somewhere");
    if (tick.p_WQ.z() < 0) {
      tick.phase = Phase::slip;
      tick.normal_W = Vec3::UnitZ();
      tick.force_W_n = Vec3(0.3, 0, 1) * -1e5 * tick.p_WQ.z();
    }
    const DeviceAnswer answer = finger_.feel(tick, now_ns_, true);
    promise(answer.force_D_n.allFinite() && answer.torque_D_n_m.allFinite(), "forces are finite");
    promise(answer.force_D_n.norm() <= 5, "no force is above the limit");
  }
  std::int64_t now_ns() const { return now_ns_; }

 private:
  RemoteFinger finger_{DeviceSettings{}, {0, Vec3::UnitZ(), Vec3::UnitY()}};
  std::int64_t now_ns_ = 0;
  std::uint64_t said_ = 0;
};

}  // namespace

void fuzz_device_packets(std::string_view bytes) {
  HostileDevice device;
  PacketGate gate;
  std::vector<unsigned char> all(bytes.begin(), bytes.end());
  for (std::size_t at = 0; at < all.size(); at += packet_bytes) {
    const std::span<const unsigned char> packet(&all[at], std::min(packet_bytes, all.size() - at));
    DevicePacket read;
    if (gate.pass(packet, PacketSender{}, device.now_ns(), read)) {
      device.say(place_of(read));
      promise(std::ranges::equal(packet_of(read), packet), "what is accepted was read to the last bit");
    }
    device.tick();
  }
}

void fuzz_haply_frame(std::string_view bytes) {
  const auto frame = read_haply_frame(bytes);
  if (!frame) return;
  HostileDevice device;
  for (int k = 0; k < 60; ++k) {
    device.say(frame->place);
    device.tick();
  }
  const auto message =
      nlohmann::json::parse(haply_message(frame->device_id, Vec3::UnitX(), ""), nullptr, false);
  promise(message.is_object(), "a message can be written whatever the device's name");
  promise(message["inverse3"][0]["device_id"] == frame->device_id, "it goes to the device that was heard");
}

}  // namespace fingerpad::test
