#pragma once

#include <span>
#include <string>

#include "device/packet_gate.hpp"

namespace fingerpad {

/// A UDP socket that never blocks.
class UdpSocket {
 public:
  /// @param address  a numeric IPv4 or IPv6 address of this machine
  /// @param port     0: one that is free
  /// Throws Error (usage) where it cannot be had.
  UdpSocket(const std::string& address, int port);
  ~UdpSocket();
  UdpSocket(const UdpSocket&) = delete;
  UdpSocket& operator=(const UdpSocket&) = delete;

  int descriptor() const noexcept { return descriptor_; }
  /// "127.0.0.1:47110", with the port that it has.
  const std::string& name() const noexcept { return name_; }

  /// The next packet, cut where the buffer ends. @returns its length; -1 where there is none
  long receive(std::span<unsigned char> buffer, PacketSender& sender) noexcept;
  /// To whom a packet came from. What cannot be sent now is lost, as on any network.
  void send(std::span<const unsigned char> bytes, const PacketSender& to) noexcept;

 private:
  int descriptor_ = -1;
  std::string name_;
};

}  // namespace fingerpad
