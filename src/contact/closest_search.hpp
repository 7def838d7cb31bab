#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "contact/packed_part.hpp"
#include "contact/packet_filter.hpp"
#include "contact/packet_scene.hpp"
#include "contact/triangle_tree.hpp"

namespace fingerpad {

/// The closest triangle so far.
struct Winner {
  int triangle = std::numeric_limits<int>::max();
  FramePoint at;

  /// Whether triangle t is closer, or as close and lower.
  bool beaten_by(int t, const FramePoint& p) const noexcept {
    return p.distance2_m2 < at.distance2_m2 || (p.distance2_m2 == at.distance2_m2 && t < triangle);
  }
};

/// A query point as Embree and the packets' filter see it.
struct ScaledPoint {
  const PackedPart* packed;
  PacketFilter filter;
  Vec3 q;
  double tie_m;
  Vec3 scaled;
  float embree[3];     ///< scaled, as Embree has it
  double rounding;     ///< how far Embree's query point lies from q, scaled
  float exact_margin;  ///< the last term of rough_margin's claim

  ScaledPoint(const PackedPart& part, PacketFilter packet_filter, const Vec3& point) noexcept
      : packed(&part),
        filter(packet_filter),
        q(point),
        tie_m(tie_distance_m(*part.part, point)),
        scaled(point * part.scale) {
    for (int i = 0; i < 3; ++i) embree[i] = static_cast<float>(scaled[i]);
    rounding = (scaled - Vec3(embree[0], embree[1], embree[2])).cwiseAbs().sum();
    exact_margin = static_cast<float>(2e-14 * (1 + scaled.cwiseAbs().sum()));
  }

  /// Embree's radius for everything within a distance.
  float radius(double distance_m) const noexcept {
    return static_cast<float>((distance_m * packed->scale + rounding) * (1 + relative_slack) +
                              absolute_slack);
  }

  /// A distance that is looked for, as a float no smaller.
  float rough(double distance_m) const noexcept {
    constexpr double largest = std::numeric_limits<float>::max();
    return static_cast<float>(std::min(distance_m * packed->scale, largest)) * (1 + 0x1p-22f);
  }

  FramePoint exact(const TrianglePacket& packet, int lane) const noexcept {
    return closest_in(exact_frame(*packed->part, packet, lane), q, tie_m);
  }
};

/// A packet as seen from a point.
struct PacketView {
  const TrianglePacket* packet;
  float r[3];
  float margin;  ///< no rough distance is off by more

  PacketView(const ScaledPoint& point, const TrianglePacket& seen) noexcept : packet(&seen) {
    float sum = 0;
    for (int i = 0; i < 3; ++i) {
      r[i] = static_cast<float>(point.scaled[i] - seen.origin[i]);
      sum += std::abs(r[i]);
    }
    margin = rough_margin * (sum + 2 * seen.radius) + point.exact_margin;
  }

  /// The square that a rough distance must not exceed where the true one is at most `distance`.
  float limit2(float distance) const noexcept {
    const float limit = distance + margin;
    return limit * limit * (1 + 0x1p-21f);
  }

  /// A rough distance whose square does not exceed this has a true one that is no larger than what
  /// ScaledPoint::rough made `distance` of. Negative where there is none.
  float surely_within2(float distance) const noexcept {
    const float limit = distance * (1 - 0x1p-20f) - margin;
    return limit > 0 ? limit * limit * (1 - 0x1p-21f) : -1;
  }
};

/// A search for the closest triangle.
struct ClosestSearch : ScaledPoint {
  Winner winner;
  float best;                                 ///< the winner's distance, rough and no smaller
  const TrianglePacket* won_in = nullptr;     ///< the winner's packet
  int won_lane = 0;                           ///< its lane there
  const TrianglePacket* looked_at = nullptr;  ///< before Embree's search

  ClosestSearch(const PackedPart& part, PacketFilter packet_filter, const Vec3& point,
                double reach_m) noexcept
      : ScaledPoint(part, packet_filter, point) {
    winner.at.distance2_m2 = reach_m * reach_m;
    best = rough(reach_m);
  }

  /// Looks at the packet of a triangle that is likely close, and at this triangle first of all.
  void look_at_seed(int triangle) noexcept {
    look_at_slot(packed->slot_of[static_cast<std::size_t>(triangle)]);
  }
  /// The same of one whose slot is known.
  void look_at_slot(std::uint32_t slot) noexcept {
    const TrianglePacket& packet = packed->packets[slot / packet_width];
    looked_at = &packet;
    const int lane = static_cast<int>(slot % packet_width);
    // The filter will want all of it: let it come while the seed is looked at.
    for (std::ptrdiff_t line = 0; line < 640; line += 64) {
      __builtin_prefetch(reinterpret_cast<const char*>(&packet) + line);
    }
    if (look_at(packet, lane)) best = rough(std::sqrt(winner.at.distance2_m2));
    look_at(packet, lanes_within_best(packet) & ~(1U << lane));
  }

  /// Where the winner stands. @pre there is one
  std::uint32_t won_slot() const noexcept {
    return static_cast<std::uint32_t>((won_in - packed->packets.data()) * packet_width + won_lane);
  }

  /// Whether a winner is known that is not far away in the size of its packet.
  bool is_beside_winner() const noexcept { return won_in != nullptr && best <= 4 * won_in->radius; }

  /// Whether none of a packet's triangles can win, by the disc around them.
  template <class PacketOrDisc>
  bool passes_over(const PacketOrDisc& seen) const noexcept {
    return seen.least_distance(scaled) > static_cast<double>(best + exact_margin);
  }

  ClosestTriangle answer() const noexcept {
    if (won_in == nullptr) return {};
    return {winner.triangle, in_part_corners(winner.at, lane_order(*won_in, won_lane))};
  }

  /// True if a closer triangle was found.
  bool look_at(const TrianglePacket& packet) noexcept { return look_at(packet, lanes_within_best(packet)); }

 private:
  bool look_at(const TrianglePacket& packet, unsigned lanes) noexcept {
    bool closer = false;
    for (; lanes != 0; lanes &= lanes - 1) closer |= look_at(packet, std::countr_zero(lanes));
    if (closer) best = rough(std::sqrt(winner.at.distance2_m2));
    return closer;
  }

  bool look_at(const TrianglePacket& packet, int lane) noexcept {
    const int triangle = packet.exact[static_cast<std::size_t>(lane)].triangle;
    const FramePoint p = exact(packet, lane);
    if (!winner.beaten_by(triangle, p)) return false;
    const bool closer = p.distance2_m2 < winner.at.distance2_m2;
    winner = {triangle, p};
    won_in = &packet;
    won_lane = lane;
    return closer;
  }

  /// The lanes that could be as near as the winner. Where there are several, only those among them that could
  /// be the nearest.
  unsigned lanes_within_best(const TrianglePacket& packet) noexcept {
    const PacketView view(*this, packet);
    RoughDistances distances;
    unsigned lanes = filter(packet, view.r, view.limit2(best), distances);
    lanes = (lanes | packet.always_exact) & packet.used;
    if ((lanes & (lanes - 1)) != 0) lanes &= nearest_lanes(packet, view, distances) | packet.always_exact;
    return lanes;
  }

  /// The lanes that could be nearest of the packet.
  static unsigned nearest_lanes(const TrianglePacket& packet, const PacketView& view,
                                const RoughDistances& distances) noexcept {
    float least = distances.squared[0];
    for (const float squared : distances.squared) least = std::min(least, squared);
    const float limit2 = view.limit2((std::sqrt(least) + view.margin) * (1 + 0x1p-22f));
    unsigned lanes = 0;
    for (unsigned lane = 0; lane < packet_width; ++lane) {
      lanes |= static_cast<unsigned>(distances.squared[lane] <= limit2) << lane;
    }
    return lanes & packet.used;
  }
};

}  // namespace fingerpad
