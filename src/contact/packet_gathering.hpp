#pragma once

#include "contact/packet_list.hpp"

namespace fingerpad {

/// Packets that may stand near a piece of way, and how far from it they are at least: what a list is made of.
/// Lengths scaled.
struct PacketGathering {
  static constexpr std::size_t most = 192;

  std::size_t count = 0;
  std::array<std::uint32_t, most> packet;
  /// Of each, the square, and of some more up to a multiple of four.
  alignas(32) std::array<double, most> distance2;

  bool is_full() const noexcept { return count == most; }
  void add(std::uint32_t index) noexcept { packet[count++] = index; }
};

/// How far packets are from a way at least: how high over a packet's disc it comes at least, and how far
/// beside it. Writes the squares of a gathering's packets.
/// @param discs  of all packets of the part
/// @pre the gathering holds one at least. noexcept, allocates nothing.
using DiscMeasure = void (*)(const PacketDisc* discs, const PathPiece& way,
                             PacketGathering& gathering) noexcept;

/// The fastest one that this machine can run, and the one that every machine can; both give the same bits.
DiscMeasure fastest_disc_measure() noexcept;
DiscMeasure plain_disc_measure() noexcept;

/// Puts the packets within a distance into a list, or the nearest of them, and leaves no others gathered.
/// @param anchor     near the way, a float in each coordinate
/// @param within     the distance
/// @returns  what no packet that is not listed is nearer than. noexcept, allocates nothing.
double put_into(PacketList& list, const PacketDisc* discs, const Vec3& anchor, double within,
                PacketGathering& gathering) noexcept;

}  // namespace fingerpad
