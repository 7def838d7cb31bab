#include "device/remote_device.hpp"

#include <fmt/format.h>

#include "base/number_text.hpp"

namespace fingerpad {

RemoteDevice::RemoteDevice(const DeviceSetup& setup, Answers answers, DeviceClock clock)
    : clock_(clock),
      watchdog_s_(setup.scene.device.watchdog_s),
      answers_wanted_(answers),
      finger_(setup.scene.device, setup.start) {}

void RemoteDevice::start() {
  thread_ = std::thread([this] { run(); });
}

void RemoteDevice::stop() {
  stopping_ = true;
  wake_up_.wake();
  if (thread_.joinable()) thread_.join();
}

FingerSample RemoteDevice::advance(double dt_s) noexcept {
  DeviceReading reading;
  if (readings_.take(reading)) finger_.hear(reading);
  return finger_.advance(clock_(), dt_s);
}

void RemoteDevice::feel(const TickRecord& tick) noexcept {
  const bool is_first = finger_.heard() != answered_,
             is_sent = is_first || answers_wanted_ == Answers::every_tick;
  const DeviceAnswer answer = finger_.feel(tick, clock_(), is_sent);
  if (is_sent) answers_.put(answer);
  if (!is_first) return;  // the device's thread waits for no other
  answered_ = finger_.heard();
  wake_up_.wake();
}

DeviceAnswer& RemoteDevice::newest_answer() noexcept {
  answers_.take(newest_);
  if (finger_.guard().stopped()) {  // also where the stop has come since that tick
    newest_.force_D_n = newest_.torque_D_n_m = Vec3::Zero();
    newest_.stopped = true;
  }
  return newest_;
}

std::string RemoteDevice::silence_words(const std::string& what, bool is_silent) const {
  const TripWatch::Lately lately = trips().lately(now_ns());
  const double patience_ms = 1e3 * watchdog_s_;
  // The same words while it is lifted and put down in turns: they stay to be read.
  if (lately == TripWatch::Lately::again)
    return fmt::format("no {} for {} ms: finger lifted, again and again", what, rounded_text(patience_ms, 4));
  if (!is_silent && lately == TripWatch::Lately::none) return {};
  return fmt::format("no {} for {} ms: finger {}", what, rounded_text(patience_ms, 4),
                     is_silent ? "lifted" : "was lifted");
}

std::string RemoteDevice::stop_words() const {
  return emergency_stopped() ? "; the emergency stop was on at the end: no force" : "";
}

}  // namespace fingerpad
