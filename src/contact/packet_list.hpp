#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "contact/packet_filter.hpp"

namespace fingerpad {

/// A piece of straight way: from `middle - half` to `middle + half`.
struct PathPiece {
  Vec3 middle, half;
};

/// The packets that come near a piece of straight way: all within a distance of it. While the ball of a
/// query, which reaches from its point as far as the closest triangle, stays within that distance of the way,
/// no other packet can hold that triangle. Two and a half kilobytes.
struct PacketList {
  static constexpr int groups = 8, most = groups * packet_width;

  int count = 0;
  double clear_m = -1;  ///< no triangle of a packet that is not listed is nearer to the way; < 0: no list
  Vec3 middle = Vec3::Zero(), half = Vec3::Zero();  ///< of the way: from middle - half to middle + half [m]
  double per_half2 = 0;        ///< one over the square of half's length; 0 where the way is a point
  Vec3 anchor = Vec3::Zero();  ///< scaled: what the discs' places are relative to
  float spread = 0;            ///< no disc reaches farther from there, by the sum of coordinates and radius
  std::array<std::uint32_t, most> packet{};
  std::array<PacketDiscs, groups> discs{};  // ordinary numbers too where nothing is listed

  void clear() noexcept {
    count = 0;
    clear_m = -1;
  }
  bool is_list() const noexcept { return clear_m >= 0; }

  /// Where a point stands along the way: -1 at its beginning, 1 at its end.
  double along(const Vec3& q) const noexcept { return (q - middle).dot(half) * per_half2; }
  /// Whether no packet that is not listed can hold a triangle as near to q as `distance_m`.
  bool covers(const Vec3& q, double distance_m) const noexcept {
    const Vec3 off = q - middle;
    const double at = std::clamp(off.dot(half) * per_half2, -1.0, 1.0), room_m = clear_m - distance_m;
    return room_m > 0 && (off - at * half).squaredNorm() < room_m * room_m;
  }
};

}  // namespace fingerpad
