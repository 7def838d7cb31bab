#pragma once

#include <optional>

#include "device/haply_message.hpp"
#include "device/remote_device.hpp"
#include "device/web_socket.hpp"

namespace fingerpad {

/// An Inverse3 by Haply's Inverse Service. A thread of its own speaks with the service: a force, a state, a
/// force ..., each force that of the tick after the state. Where either side is silent for longer than the
/// watchdog allows, the device is sent a force of 0: where the service is, since the finger is lifted then;
/// where the servo is, since its last force is too old. A state that never comes is asked for anew. A service
/// that goes is looked for twice a second, until the same device is there again.
class HaplyDevice final : public RemoteDevice {
 public:
  /// Throws Error (usage) where no service answers, or it has no Inverse3.
  HaplyDevice(const DeviceSetup& setup, DeviceClock clock = steady_clock_ns);
  ~HaplyDevice() override { stop(); }

  std::string trouble() const override;
  std::string opening_words() const override;
  std::string closing_words() override;

 private:
  void run() override;
  void speak();
  bool find_again();
  void connect();
  Vec3 force_D_n() noexcept;
  void wait_for_tick() noexcept;
  bool say(const Vec3& force_D_n);
  bool answer(const std::string& text);
  bool ask_in_silence();
  bool hear(const std::string& text);
  int patience_ms() const noexcept;

  const int port_;
  std::optional<WebSocket> socket_;  // device's thread, once it runs, as all below but for away_
  std::string device_id_;
  std::uint64_t states_ = 0, dropped_ = 0, said_ = 0, lost_ = 0;
  std::uint64_t owed_ = 0;    ///< states that the service has still to send
  bool asked_ = false;        ///< the last message was one of a silence
  std::int64_t last_ns_ = 0;  ///< when a message came, or the service was taken to have lost what it owed
  int found_again_ = 0;
  std::atomic<bool> away_{false};  ///< the service has gone
};

}  // namespace fingerpad
