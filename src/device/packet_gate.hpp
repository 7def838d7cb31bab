#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "device/device_packet.hpp"

namespace fingerpad {

/// Who sent a packet: a socket address as it lies in memory.
struct PacketSender {
  std::array<unsigned char, 28> address{};  ///< room for IPv6
  unsigned length = 0;
  bool operator==(const PacketSender&) const = default;
};

/// Whether `sequence` comes after `last` (serial-number arithmetic, RFC 1982): the numbers go round, and what
/// is half of them away is not after it.
constexpr bool comes_after(std::uint32_t sequence, std::uint32_t last) noexcept {
  const std::uint32_t ahead = sequence - last;
  return ahead != 0 && ahead < 0x80000000u;
}

/// Lets the packets of one sender pass, the first. When none of his has passed for 1 s, anyone may begin
/// anew, with any sequence: another, or he himself after a restart. What does not pass is counted by its
/// reason.
class PacketGate {
 public:
  struct Counts {
    std::uint64_t accepted = 0;
    std::uint64_t malformed = 0;  ///< another length or magic
    std::uint64_t numbers = 0;    ///< not finite, too far, no unit quaternion
    std::uint64_t old = 0;        ///< an old or repeated sequence, or 0
    std::uint64_t other = 0;      ///< of another sender
    std::uint64_t dropped() const noexcept { return malformed + numbers + old + other; }
    bool operator==(const Counts&) const = default;
  };

  /// @returns whether the packet passes, which then is in `packet`
  bool pass(std::span<const unsigned char> bytes, const PacketSender& sender, std::int64_t now_ns,
            DevicePacket& packet) noexcept;

  const Counts& counts() const noexcept { return counts_; }
  /// The one who is heard. @pre a packet has passed
  const PacketSender& sender() const noexcept { return sender_; }

 private:
  Counts counts_;
  PacketSender sender_;
  std::int64_t last_ns_ = 0;
  std::uint32_t last_sequence_ = 0;
};

/// "1000 packets accepted, 3 dropped: 2 malformed, 1 old or repeated".
std::string counts_text(const PacketGate::Counts& counts);

}  // namespace fingerpad
