#pragma once

#include <atomic>

#include "device/remote_device.hpp"
#include "device/udp_socket.hpp"

namespace fingerpad {

/// A device behind a socket: it sends packets with its place, and is answered with the force (see
/// device_packet.hpp). A thread of its own receives and answers; the servo only ever exchanges values with
/// it. Every accepted packet is answered once, after the next tick.
class NetworkDevice final : public RemoteDevice {
 public:
  /// Throws Error (usage) where the port cannot be had.
  NetworkDevice(const DeviceSetup& setup, DeviceClock clock = steady_clock_ns);
  ~NetworkDevice() override { stop(); }

  /// That nobody is heard: not yet, or for as long as lifts the finger; for a while after it, too.
  std::string trouble() const override;
  std::string opening_words() const override;
  std::string closing_words() override;

  /// "127.0.0.1:47110".
  const std::string& name() const noexcept { return socket_.name(); }
  /// What has come so far. One thread.
  PacketGate::Counts counts() noexcept;

 private:
  void run() override;
  void receive() noexcept;
  void answer() noexcept;

  UdpSocket socket_;
  PacketGate gate_;             // device's thread, as all below
  std::uint64_t answered_ = 0;  ///< accepted packets that were answered
  std::uint32_t answer_sequence_ = 0;
  std::atomic<std::int64_t> heard_ns_{-1};  ///< when the last packet was accepted; -1: none was yet
  std::atomic<bool> dropped_{false};        ///< packets have come that were not
  Latest<PacketGate::Counts> counted_;      // to whoever asks
  PacketGate::Counts counts_;               // the asker's
};

/// Where a packet says that its device is.
DevicePlace place_of(const DevicePacket& packet) noexcept;

}  // namespace fingerpad
