#pragma once

#include <atomic>
#include <thread>

#include "device/device_clock.hpp"
#include "device/latest.hpp"
#include "device/live_device.hpp"
#include "device/remote_finger.hpp"
#include "device/udp_socket.hpp"
#include "device/wake_up.hpp"

namespace fingerpad {

/// A device behind a socket: it sends packets with its place, and is answered with the force (see
/// device_packet.hpp). A thread of its own receives and answers; the servo only ever exchanges values with
/// it. Every accepted packet is answered once, after the next tick.
class NetworkDevice final : public LiveDevice {
 public:
  /// Throws Error (usage) where the port cannot be had.
  NetworkDevice(const DeviceSetup& setup, DeviceClock clock = steady_clock_ns);
  ~NetworkDevice() override;

  FingerSample advance(double dt_s) override;
  void feel(const TickRecord& tick) noexcept override;
  bool has_motors() const noexcept override { return true; }
  Vec3 sent_W_n() const noexcept override { return finger_.sent_W_n(); }
  void set_emergency_stop(bool on) noexcept override { finger_.guard().set_stopped(on); }
  bool emergency_stopped() const noexcept override { return finger_.guard().stopped(); }
  std::string opening_words() const override;
  std::string closing_words() override;

  /// "127.0.0.1:47110".
  const std::string& name() const noexcept { return socket_.name(); }
  /// What has come so far. One thread.
  PacketGate::Counts counts() noexcept;

 private:
  void run();
  void receive() noexcept;
  void answer() noexcept;
  void stop();

  DeviceClock clock_;
  RemoteFinger finger_;  // servo thread
  UdpSocket socket_;
  WakeUp wake_up_;
  Latest<DeviceReading> readings_;  // to the servo
  Latest<DeviceAnswer> answers_;    // to the device's thread
  std::uint64_t heard_ = 0;         // servo thread: readings that an answer was made for
  PacketGate gate_;                 // device's thread, as all below
  DeviceAnswer newest_;
  std::uint64_t answered_ = 0;
  std::uint32_t answer_sequence_ = 0;
  Latest<PacketGate::Counts> counted_;  // to whoever asks
  PacketGate::Counts counts_;           // the asker's
  std::atomic<bool> stopping_{false};
  std::thread thread_;
};

}  // namespace fingerpad
