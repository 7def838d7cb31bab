#pragma once

#include "contact/packet_filter.hpp"

namespace fingerpad {

/// A half space for each triangle of a packet, rough, in which the triangle lies: what is outside of it is no
/// nearer to the triangle than to the half space. Made from a place, it is bounded there by the plane through
/// the triangle's closest point, across the way to it.
struct alignas(32) PacketTangents {
  std::array<TrianglePacket::Lanes, 3> towards;  ///< its outward normal, unit
  TrianglePacket::Lanes level;                   ///< how far it reaches from the packet's origin, scaled
};

/// A way of a ball past a packet, and where its triangles need not be looked at; scaled, and longer than what
/// is meant by the packet's margin.
struct WayPastPacket {
  float from[3], to[3];  ///< relative to the packet's origin
  /// A half space that the way stays so far outside of is not touched.
  float touched;
  /// One that the way begins farther outside of, or ends, is breached less than another is.
  float begins, ends;
  /// What is known of the end is off by this, divided by the distance from the triangle, since the way from
  /// it is not known better.
  float turn;
  float margin;  ///< of rough_margin's claim
};

/// Half spaces that tell nothing.
PacketTangents no_tangents() noexcept;

/// Makes half spaces from a place. The margin of rough_margin holds for how far outside of them places are:
/// what is outside of a half space by more than the margin there is as far from the triangle, less the
/// margin.
///
/// Proof: for any unit vector n the triangle lies in the half space of n that its farthest corner bounds. So
/// only roundings count: n is unit to 4 u, made of a frame whose axes are unit and square to 3 u each; a
/// corner's place along n is a sum of products of lengths up to 2 radius, off by 16 u times that at most; so
/// is the place's, by 4 u |r|.
/// @param r  the place less the packet's origin, scaled
using TangentMaker = void (*)(const TrianglePacket& packet, const float* r, PacketTangents& made) noexcept;
/// The lanes that may block a way, as bits.
/// @param tangents  made from where the way begins, or, where way.ends is infinite, from anywhere
/// @param ends  aligned to 32 bytes: how far outside of each half space the way ends, at least
using WayFilter = unsigned (*)(const PacketTangents& tangents, const WayPastPacket& way,
                               TrianglePacket::Lanes& ends) noexcept;
/// The same by half spaces made from where the way begins, and then, as sweep_past_triangle does it, from
/// where one of these is touched, and from there again.
using SweepFilter = unsigned (*)(const TrianglePacket& packet, const PacketTangents& tangents,
                                 const WayPastPacket& way, TrianglePacket::Lanes& ends) noexcept;
/// The lanes whose triangles reach no farther along a unit vector than a limit, as bits; none without a rough
/// frame. The margin holds here, too.
using ReachFilter = unsigned (*)(const TrianglePacket& packet, const float* along, float limit) noexcept;

/// The fastest that this machine can run, and those that every machine can; their answers are the same bits.
TangentMaker fastest_tangent_maker() noexcept;
TangentMaker plain_tangent_maker() noexcept;
WayFilter fastest_way_filter() noexcept;
WayFilter plain_way_filter() noexcept;
SweepFilter fastest_sweep_filter() noexcept;
SweepFilter plain_sweep_filter() noexcept;
ReachFilter fastest_reach_filter() noexcept;
ReachFilter plain_reach_filter() noexcept;

}  // namespace fingerpad
