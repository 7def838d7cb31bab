#pragma once

#include <atomic>
#include <thread>

#include "device/device_clock.hpp"
#include "device/haply_message.hpp"
#include "device/latest.hpp"
#include "device/live_device.hpp"
#include "device/remote_finger.hpp"
#include "device/wake_up.hpp"
#include "device/web_socket.hpp"

namespace fingerpad {

/// An Inverse3 by Haply's Inverse Service. A thread of its own speaks with the service: a force, a state, a
/// force ..., each force that of the tick after the state. Where either side is silent for longer than the
/// watchdog allows, the device is sent a force of 0: where the service is, since the finger is lifted then;
/// where the servo is, since its last force is too old.
class HaplyDevice final : public LiveDevice {
 public:
  /// Throws Error (usage) where no service answers, or it has no Inverse3.
  HaplyDevice(const DeviceSetup& setup, DeviceClock clock = steady_clock_ns);
  ~HaplyDevice() override;

  FingerSample advance(double dt_s) override;
  void feel(const TickRecord& tick) noexcept override;
  bool has_motors() const noexcept override { return true; }
  Vec3 sent_W_n() const noexcept override { return finger_.sent_W_n(); }
  void set_emergency_stop(bool on) noexcept override { finger_.guard().set_stopped(on); }
  bool emergency_stopped() const noexcept override { return finger_.guard().stopped(); }
  /// The service has gone.
  bool has_ended() const noexcept override { return gone_.load(std::memory_order_relaxed); }
  std::string opening_words() const override;
  std::string closing_words() override;

 private:
  void run();
  Vec3 force_D_n() noexcept;
  bool say(const Vec3& force_D_n);
  bool hear(const std::string& text);
  void stop();

  DeviceClock clock_;
  double watchdog_s_;
  RemoteFinger finger_;  // servo thread
  WebSocket socket_;     // device's thread, once it runs
  std::string device_id_;
  WakeUp wake_up_;
  Latest<DeviceReading> readings_;  // to the servo
  Latest<DeviceAnswer> answers_;    // to the device's thread
  std::uint64_t answered_ = 0;      // servo thread: readings that an answer was made for
  DeviceAnswer newest_;             // device's thread, as all below
  std::uint64_t states_ = 0, dropped_ = 0, said_ = 0;
  std::uint64_t owed_ = 0;  ///< states that the service has still to send
  std::atomic<bool> stopping_{false}, gone_{false};
  std::thread thread_;
};

}  // namespace fingerpad
