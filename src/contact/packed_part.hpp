#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "contact/triangle_packet.hpp"

namespace fingerpad {

/// A part's triangles in packets of neighbours.
struct PackedPart {
  std::shared_ptr<const Part> part;
  double extent_m = 0;  ///< longest half side of the part's box
  double scale = 1;     ///< scaled length of one metre: a power of two that brings the box into [-1, 1]
  std::vector<TrianglePacket> packets;
  std::vector<PacketDisc> discs;       ///< one a packet
  std::vector<std::uint32_t> slot_of;  ///< of each triangle: packet_width times its packet, plus its lane

  std::size_t packet_of(int triangle) const noexcept {
    return slot_of[static_cast<std::size_t>(triangle)] / packet_width;
  }
  int lane_of(int triangle) const noexcept {
    return static_cast<int>(slot_of[static_cast<std::size_t>(triangle)] % packet_width);
  }

  std::size_t memory_bytes() const noexcept;
};

/// Packs a part on all threads; the same packets on any number of them.
PackedPart pack(std::shared_ptr<const Part> part);

}  // namespace fingerpad
