#pragma once

#include <bit>

#include "contact/closest_search.hpp"

namespace fingerpad {

/// Beyond so many half extents only the direction of a point matters.
inline constexpr double direction_range = 1 << 20;

/// A point, or where it stands for one that far away.
inline Vec3 within_direction_range(const Vec3& q, double extent_m) noexcept {
  const double farthest = q.cwiseAbs().maxCoeff(), limit = direction_range * extent_m;
  return farthest > limit ? Vec3(q / farthest * limit) : q;
}

/// A search for all triangles within a fixed reach.
struct WithinSearch : ScaledPoint {
  double reach_m, bound_m;
  float rough_reach;
  void (*found)(void* context, int triangle);
  void* context;
  mutable float found_squared = 0, found_margin = 0;  ///< rough, of the triangle that is being passed on

  WithinSearch(const PackedPart& part, PacketFilter packet_filter, const Vec3& point, double reach,
               void (*visit)(void*, int), void* visit_context) noexcept
      : ScaledPoint(part, packet_filter, point),
        reach_m(reach),
        bound_m(std::min(reach, point.norm() + 2 * part.extent_m)),
        rough_reach(rough(bound_m)),
        found(visit),
        context(visit_context) {}

  void look_at(const TrianglePacket& packet) const noexcept {
    const PacketView view(*this, packet);
    RoughDistances distances;
    unsigned lanes = filter(packet, view.r, view.limit2(rough_reach), distances);
    lanes = (lanes | packet.always_exact) & packet.used;
    const float surely_within2 = view.surely_within2(rough_reach);
    found_margin = view.margin;
    for (; lanes != 0; lanes &= lanes - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(lanes));
      found_squared = (packet.always_exact >> lane & 1) != 0 ? 0 : distances.squared[lane];
      if (distances.squared[lane] <= surely_within2) {
        found(context, packet.exact[lane].triangle);
      } else {
        look_at(packet, static_cast<int>(lane));
      }
    }
  }

  /// The distance of the triangle that is being passed on is no smaller.
  double at_least_m() const noexcept {
    const double rough = std::sqrt(static_cast<double>(found_squared)) * (1 - 0x1p-20);
    return std::max(0.0, rough - static_cast<double>(found_margin)) / packed->scale;
  }

  void look_at(const TrianglePacket& packet, int lane) const noexcept {
    if (exact(packet, lane).distance2_m2 <= reach_m * reach_m)
      found(context, packet.exact[static_cast<std::size_t>(lane)].triangle);
  }

  /// The same for a point so far away that floats tell nothing.
  void look_from_afar_at(const TrianglePacket& packet) const noexcept {
    const Vec3 nearer = within_direction_range(q, packed->extent_m);
    const double nearer_tie_m = tie_distance_m(*packed->part, nearer);
    for (int lane = 0; lane < packet_width && (packet.used >> lane & 1) != 0; ++lane) {
      const FramePoint p = closest_in(exact_frame(*packed->part, packet, lane), nearer, nearer_tie_m);
      const bool within =
          nearer != q ? (q - p.point).stableNorm() <= reach_m : p.distance2_m2 <= reach_m * reach_m;
      if (within) found(context, packet.exact[static_cast<std::size_t>(lane)].triangle);
    }
  }
};

}  // namespace fingerpad
