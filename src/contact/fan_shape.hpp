#pragma once

#include <array>
#include <vector>

#include "contact/smooth_fan.hpp"

namespace fingerpad {

/// Twice the area of the flat face that a facet belongs to, as far as it is seen: the largest facet in its
/// plane, itself where any lies there, up to its neighbours' neighbours. 0 where none does [m^2].
double doubled_face_area_m2(const Part& part, int t) noexcept;

/// That of every facet, from a table where there is one; the same bits without.
struct FaceAreas {
  const Part& part;
  const std::vector<double>* doubled_m2 = nullptr;

  double of(int t) const noexcept {
    return doubled_m2 != nullptr ? (*doubled_m2)[static_cast<std::size_t>(t)] : doubled_face_area_m2(part, t);
  }
};

/// What a fan says of the surface at its vertex.
struct FanShape {
  /// How much each facet counts, 0 .. 1: less where it is a narrow first one of a fillet beside a flat face.
  std::array<double, SmoothFan::most_facets> counts;
  /// Each facet's normal weighted with its angle at the vertex times its area: that of the widest. The angle
  /// makes both triangles of a quad count as one facet, however it was split. Unit, or zero.
  Vec3 wide_normal;
  /// As if the vertices lay on a sphere (Max 1999), or on a cylinder in strips: each weighted with its area
  /// over both its edges' squares. Unit, or zero.
  Vec3 round_normal;
};

FanShape fan_shape(const FaceAreas& areas, std::span<const FanFacet> fan) noexcept;

}  // namespace fingerpad
