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
constexpr int inventory_patience_ms = 2000, look_again_ms = 500;
/// A service of this machine answers within milliseconds, or not at all.
constexpr std::int64_t lost_after_ns = 500'000'000;

/// The same of no service there, with the mend.
Error no_service(const Error& error) {
  return Error(
      error.kind(), "",
      error.what() +
          std::string("; start Haply's Inverse Service on this machine first, or say its port with --port"));
}

void refuse_no_service(const DeviceLink& link) {
  try {
    const WebSocket refuses(haply_host, link.port.value_or(haply_port));
  } catch (const Error& error) {
    throw no_service(error);
  }
}

}  // namespace

HaplyDevice::HaplyDevice(const DeviceSetup& setup, DeviceClock clock)
    : RemoteDevice(setup, Answers::every_tick, clock), port_(setup.link.port.value_or(haply_port)) {
  connect();
  start();
}

/// Throws Error (usage) where there is no service, no device, or another one than before.
void HaplyDevice::connect() {
  try {
    socket_.emplace(haply_host, port_);
  } catch (const Error& error) {
    throw no_service(error);
  }
  const std::string place = fmt::format("{}:{}", haply_host, port_);
  std::string inventory;
  if (socket_->hear(inventory, inventory_patience_ms) != WebSocket::Heard::message)
    throw Error(ErrorKind::usage, place, "the service there says nothing: is it Haply's Inverse Service?");
  const auto frame = read_haply_frame(inventory);
  if (!frame)
    throw Error(ErrorKind::usage, place, "what the service there says is no inventory of Haply devices");
  if (frame->device_id.empty())
    throw Error(ErrorKind::usage, place, "the Inverse Service has no Inverse3: plug one in and switch it on");
  if (!device_id_.empty() && frame->device_id != device_id_)
    throw Error(ErrorKind::usage, place, fmt::format("the Inverse Service has no Inverse3 {}", device_id_));
  if (device_id_.empty()) device_id_ = frame->device_id;
}

int HaplyDevice::patience_ms() const noexcept {
  return std::max(1, static_cast<int>(1e3 * watchdog_s()));
}

void HaplyDevice::run() {
  speak();
  while (!is_stopping() && find_again()) speak();
}

/// Until the service goes, or the touch ends.
void HaplyDevice::speak() {
  last_ns_ = now_ns();
  owed_ = said_ = 0;
  asked_ = false;
  bool there = say(force_D_n());
  std::string text;
  while (there && !is_stopping()) {
    switch (socket_->hear(text, patience_ms())) {
      case WebSocket::Heard::message:
        there = answer(text);
        break;
      case WebSocket::Heard::nothing:
        there = ask_in_silence();
        break;
      case WebSocket::Heard::closed:
        there = false;
        break;
    }
  }
  if (there) say(Vec3::Zero());
  away_.store(!there, std::memory_order_relaxed);
}

/// @returns false where the touch ends before
bool HaplyDevice::find_again() {
  while (!is_stopping()) {
    wake_up().clear();
    if (!is_stopping()) wake_up().wait(look_again_ms);
    try {
      if (is_stopping()) break;
      connect();
    } catch (const Error&) {  // not yet
      continue;
    }
    ++found_again_;
    away_.store(false, std::memory_order_relaxed);
    return true;
  }
  return false;
}

/// @returns false where the service is gone
bool HaplyDevice::answer(const std::string& text) {
  last_ns_ = now_ns();
  if (owed_ > 0) --owed_;
  if (hear(text)) wait_for_tick();
  if (owed_ > 0) return true;  // the answer to what was said in a silence calls for no other
  asked_ = false;
  return say(force_D_n());
}

/// A force of 0, once, which the service answers as soon as it can. Where that brings not all that it owes,
/// the rest is lost, and it is asked anew: nobody would speak again otherwise.
bool HaplyDevice::ask_in_silence() {
  const bool has_lost = now_ns() - last_ns_ >= lost_after_ns;
  if (asked_ && !has_lost) return true;
  if (has_lost) {
    lost_ += owed_;
    owed_ = 0;
    last_ns_ = now_ns();
  }
  asked_ = true;
  return say(Vec3::Zero());
}

/// @returns whether it is a state, which the servo then has
bool HaplyDevice::hear(const std::string& text) {
  const auto frame = read_haply_frame(text);
  if (!frame || frame->device_id != device_id_) {
    ++dropped_;
    return false;
  }
  DeviceReading reading;
  reading.place = frame->place;
  reading.arrived_ns = now_ns();
  reading.accepted = ++states_;
  hand_over(reading);
  return true;
}

/// Until a tick has felt the last state; no longer than the watchdog allows.
void HaplyDevice::wait_for_tick() noexcept {
  while (newest_answer().accepted < states_ && wake_up().wait(patience_ms())) wake_up().clear();
}

/// The force of the last tick, unless that is too long ago.
Vec3 HaplyDevice::force_D_n() noexcept {
  const DeviceAnswer& newest = newest_answer();
  const double age_s = 1e-9 * static_cast<double>(now_ns() - newest.made_ns);
  return age_s < watchdog_s() ? newest.force_D_n : Vec3(Vec3::Zero());
}

bool HaplyDevice::say(const Vec3& force_D_n) {
  ++owed_;
  return socket_->say(haply_message(device_id_, force_D_n, said_++ == 0 ? haply_profile : ""));
}

std::string HaplyDevice::opening_words() const {
  return fmt::format("Inverse3 {}", device_id_);
}

std::string HaplyDevice::trouble() const {
  return away_ ? "the Inverse Service is gone: no force; it is looked for twice a second" : "";
}

std::string HaplyDevice::closing_words() {
  stop();
  const std::string lost = lost_ > 0 ? fmt::format("; {} answers of the service never came", lost_) : "";
  const std::string again =
      found_again_ > 0 ? fmt::format("; the Inverse Service was found again {} times", found_again_) : "";
  return fmt::format("{} states, {} dropped{}{}{}{}{}", states_, dropped_,
                     trips_words(trips(), "state", states_, watchdog_s()), stop_words(), lost, again,
                     away_ ? "; the Inverse Service ended before the touch did" : "");
}

DeviceEntry haply_device() noexcept {
  return {.name = "haply",
          .doc = "an Inverse3 by Haply's Inverse Service on this machine (--port)",
          .make = [](const DeviceSetup& setup) -> std::unique_ptr<LiveDevice> {
            return std::make_unique<HaplyDevice>(setup);
          },
          .takes_port = true,
          .reads_settings = true,
          .refuse = [](const Scene&, const DeviceLink& link) { refuse_no_service(link); }};
}

}  // namespace fingerpad
