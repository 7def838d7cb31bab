#include "device/haply_device.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "device/device_table.hpp"

namespace fingerpad {
namespace {

constexpr const char* haply_host = "localhost";
constexpr int haply_port = 10001;
constexpr const char* haply_profile = "fingerpad";
constexpr int inventory_patience_ms = 2000;

}  // namespace

HaplyDevice::HaplyDevice(const DeviceSetup& setup, DeviceClock clock)
    : clock_(clock),
      watchdog_s_(setup.scene.device.watchdog_s),
      finger_(setup.scene.device, setup.start, setup.scene.finger.radius_m),
      socket_(haply_host, setup.link.port.value_or(haply_port)) {
  std::string inventory;
  const std::string place = fmt::format("{}:{}", haply_host, setup.link.port.value_or(haply_port));
  if (socket_.hear(inventory, inventory_patience_ms) != WebSocket::Heard::message)
    throw Error(ErrorKind::usage, place, "the service there says nothing: is it Haply's Inverse Service?");
  const auto frame = read_haply_frame(inventory);
  if (!frame)
    throw Error(ErrorKind::usage, place, "what the service there says is no inventory of Haply devices");
  if (frame->device_id.empty())
    throw Error(ErrorKind::usage, place, "the Inverse Service has no Inverse3: plug one in and switch it on");
  device_id_ = frame->device_id;
  thread_ = std::thread([this] { run(); });
}

HaplyDevice::~HaplyDevice() {
  stop();
}

void HaplyDevice::stop() {
  stopping_ = true;
  wake_up_.wake();
  if (thread_.joinable()) thread_.join();
}

FingerSample HaplyDevice::advance(double dt_s) {
  DeviceReading reading;
  if (readings_.take(reading)) finger_.hear(reading);
  return finger_.advance(clock_(), dt_s);
}

void HaplyDevice::feel(const TickRecord& tick) noexcept {
  answers_.put(finger_.feel(tick, clock_(), true));
  if (finger_.heard() == answered_) return;  // the device's thread waits for no other
  answered_ = finger_.heard();
  wake_up_.wake();
}

void HaplyDevice::run() {
  const int patience_ms = std::max(1, static_cast<int>(1e3 * watchdog_s_));
  bool there = say(force_D_n()), silent = false;
  std::string text;
  while (there && !stopping_) {
    const WebSocket::Heard heard = socket_.hear(text, patience_ms);
    if (heard == WebSocket::Heard::message) {
      silent = false;
      if (hear(text)) wake_up_.wait(patience_ms);  // for the tick that feels the state
      wake_up_.clear();
      // The answer to what was said in a silence calls for no other.
      if (owed_ == 0) there = say(force_D_n());
    } else if (heard == WebSocket::Heard::closed) {
      there = false;
    } else if (!silent) {
      silent = true;
      there = say(Vec3::Zero());
    }
  }
  if (there) say(Vec3::Zero());
  gone_.store(!stopping_, std::memory_order_relaxed);
}

/// @returns whether it is a state, which the servo then has
bool HaplyDevice::hear(const std::string& text) {
  if (owed_ > 0) --owed_;
  const auto frame = read_haply_frame(text);
  if (!frame || frame->device_id != device_id_) {
    ++dropped_;
    return false;
  }
  DeviceReading reading;
  reading.place = frame->place;
  reading.arrived_ns = clock_();
  reading.accepted = ++states_;
  readings_.put(reading);
  return true;
}

/// The force of the last tick, unless that is too long ago.
Vec3 HaplyDevice::force_D_n() noexcept {
  answers_.take(newest_);
  const double age_s = 1e-9 * static_cast<double>(clock_() - newest_.made_ns);
  return age_s < watchdog_s_ && !finger_.guard().stopped() ? newest_.force_D_n : Vec3(Vec3::Zero());
}

bool HaplyDevice::say(const Vec3& force_D_n) {
  ++owed_;
  return socket_.say(haply_message(device_id_, force_D_n, said_++ == 0 ? haply_profile : ""));
}

std::string HaplyDevice::opening_words() const {
  return fmt::format("Inverse3 {}", device_id_);
}

std::string HaplyDevice::closing_words() {
  stop();
  return fmt::format("{} states, {} dropped{}", states_, dropped_,
                     gone_ ? "; the Inverse Service ended before the touch did" : "");
}

DeviceEntry haply_device() noexcept {
  return {.name = "haply",
          .doc = "an Inverse3 by Haply's Inverse Service on this machine (--port)",
          .make = [](const DeviceSetup& setup) -> std::unique_ptr<LiveDevice> {
            return std::make_unique<HaplyDevice>(setup);
          }};
}

}  // namespace fingerpad
