#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "contact/triangle_frame.hpp"

namespace fingerpad {

/// How many triangles a packet holds: a vector register of floats.
inline constexpr int packet_width = 8;

/// How far a flat disc reaches beyond its centre in a direction, times the direction's length.
/// @param across  about a unit vector, normal to the disc
inline double highest_of_disc(const Vec3& direction, const Vec3& across, double radius,
                              double half_thickness) noexcept {
  const double per_length2 = 1 / across.squaredNorm();
  return std::abs(direction.dot(across)) * per_length2 * half_thickness +
         std::sqrt(direction.cross(across).squaredNorm() * per_length2) * radius;
}

/// Eight neighbouring triangles prepared for closest-point queries: rough frames in float that a filter
/// compares all at once, and what the exact answer in double needs.
///
/// A rough frame has its origin at the foot of the altitude on the triangle's longest side, x along that
/// side, y towards the corner opposite, z out of the plane. The altitude (the y axis) cuts the triangle into
/// two right-angled halves, left (x < 0) and right; as the angles at the longest side are acute, the nearest
/// point of the triangle always lies in the half on the query's side. Lengths are scaled (see PackedPart)
/// and rough origins are relative to `origin`.
struct alignas(64) TrianglePacket {
  using Lanes = std::array<float, packet_width>;

  /// A right-angled half: corners (0, 0), (width, 0), (0, height) in x and y, x counted away from the
  /// altitude.
  struct Half {
    Lanes width;               ///< of its side on the x axis
    Lanes normal_x, normal_y;  ///< outward normal of its hypotenuse, both >= 0
    Lanes hypotenuse;          ///< length
  };

  /// What a triangle's exact frame is built from.
  struct Exact {
    Vec3 normal;             ///< of its TriangleFrame
    std::int32_t vertex[3];  ///< columns of Part::vertices in the frame's order
    std::int32_t triangle;   ///< index into Part::triangles
  };

  std::array<Lanes, 3> foot, x_axis, y_axis, z_axis;
  std::array<Half, 2> half;  ///< right, left
  std::array<Exact, packet_width> exact;
  Vec3 origin;                                   ///< centre of the box of all corners, scaled
  float radius;                                  ///< no corner is farther from `origin`, scaled
  float box_half[3];                             ///< half sides of that box, scaled, rounded up
  std::array<std::uint8_t, packet_width> order;  ///< corner_order of each triangle, two bits a corner
  std::uint8_t used;                             ///< bit k: lane k holds a triangle
  std::uint8_t always_exact;  ///< bit k: no rough frame (a sliver, or no area); the filter sees it far off
  std::uint16_t thickness;  ///< no corner is farther from the plane through `origin` that `across` is normal
                            ///< to than this share of the radius, in 65,535ths
  float across[3];          ///< about a unit vector: the triangles' mean normal

  /// No corner is farther from the plane of `thickness`, scaled.
  double half_thickness() const noexcept { return static_cast<double>(radius) * thickness * (1.0 / 65535); }

  /// How far at most a corner stands beyond `origin` in a direction (unit), scaled.
  double highest(const Vec3& direction) const noexcept {
    return highest_of_disc(direction, Vec3(across[0], across[1], across[2]), radius, half_thickness());
  }

  /// How far its triangles are from a point at least, scaled: by the flat disc around them, as `radius` and
  /// `thickness` tell it.
  double least_distance(const Vec3& at) const noexcept {
    // `across` may be longer than 1 by a float's rounding: that must not make the gap larger.
    constexpr double shorter = 1 - 1e-6;
    const Vec3 normal(across[0], across[1], across[2]), off = at - origin;
    const double height = std::abs(normal.dot(off)), size = static_cast<double>(radius);
    const double along2 = off.squaredNorm() - height * height / normal.squaredNorm();
    const double above = std::max(0.0, (height - half_thickness()) * shorter);
    const double beside = std::max(0.0, std::sqrt(std::max(0.0, along2)) - size);
    return std::sqrt(above * above + beside * beside);
  }
};

/// A flat disc around a packet by itself, half a cache line, so that many packets are soon passed over. It is
/// tighter than what the packet tells: its centre lies amid the triangles, not amid their box. Lengths
/// scaled.
struct alignas(32) PacketDisc {
  float centre[3];
  float radius;     ///< along its plane nothing of the packet is farther from the centre
  float across[3];  ///< about a unit vector
  float thick;      ///< nothing of the packet is farther from the plane through the centre

  /// How far at most something of the packet stands beyond the centre in a direction, times its length.
  double highest(const Vec3& direction) const noexcept {
    return highest_of_disc(direction, Vec3(across[0], across[1], across[2]), radius, thick);
  }

  /// How far the packet's triangles are from a point at least.
  double least_distance(const Vec3& at) const noexcept {
    constexpr double shorter = 1 - 1e-6,
                     longer = 1 + 1e-6;  // `across` is of length 1 up to a float's rounding
    const Vec3 off = at - Vec3(centre[0], centre[1], centre[2]);
    const double height = std::abs(Vec3(across[0], across[1], across[2]).dot(off));
    const double along2 = off.squaredNorm() - height * height * longer;
    const double above = std::max(0.0, height * shorter - static_cast<double>(thick));
    const double beside = std::max(0.0, std::sqrt(std::max(0.0, along2)) - static_cast<double>(radius));
    return std::sqrt(above * above + beside * beside);
  }
};

/// @param scale  as the packet's
PacketDisc disc_around(const Part& part, const TrianglePacket& packet, double scale) noexcept;

/// A lane whose rough frame means nothing has its origin so far off that no distance comes near.
inline constexpr float far_off = 1e18f;

/// The packet of up to eight triangles of a part.
/// @param triangles  indices into Part::triangles, ascending
/// @param scale      a power of two that brings the part's box into [-1, 1]
TrianglePacket make_packet(const Part& part, std::span<const std::int32_t> triangles, double scale) noexcept;

/// corner_order of a lane's triangle.
inline std::array<int, 3> lane_order(const TrianglePacket& packet, int lane) noexcept {
  const int bits = packet.order[static_cast<std::size_t>(lane)];
  return {bits & 3, bits >> 2 & 3, bits >> 4};
}

/// The exact frame of a lane in use.
inline TriangleFrame exact_frame(const Part& part, const TrianglePacket& packet, int lane) noexcept {
  const TrianglePacket::Exact& e = packet.exact[static_cast<std::size_t>(lane)];
  return {{part.vertices.col(e.vertex[0]), part.vertices.col(e.vertex[1]), part.vertices.col(e.vertex[2])},
          e.normal};
}

}  // namespace fingerpad
