#pragma once

#include <algorithm>
#include <span>

#include "contact/proxy_sweep.hpp"

namespace fingerpad {

/// A wall in a part's frame, as the part's triangles are held against it.
struct PartWall {
  Vec3 normal = Vec3::UnitZ();
  double offset_m = 0;  ///< triangles up to here stand behind it
};

/// A triangle in a proxy's view, and what is known of its distance. The distance to a triangle is a convex
/// function of the place that changes no faster than the place does, so that one look bounds it everywhere.
struct NearTriangle {
  Vec3 towards = Vec3::Zero();  ///< unit, from the triangle to where it was looked at from
  double level_m = 0;           ///< the gap that the tangent there leaves at the part's centre
  double gap_m = 0;             ///< distance from there less the clearance
  int triangle = -1;
  bool seen = false;  ///< looked at so far; most stand behind the wall that holds the proxy and never are
  TriangleCorners corners;
  Vec3 seen_from = Vec3::Zero();  ///< in the part's frame [m]

  void look_from(const Vec3& place, double clearance_m) noexcept {
    const TriangleApproach approach = approach_triangle(corners, place);
    seen = true;
    seen_from = place;
    towards = approach.towards;
    gap_m = approach.distance_m - clearance_m;
    level_m = gap_m - towards.dot(place);
  }

  /// The gap that the tangent leaves at a place; the true one is no smaller.
  double least_gap_m(const Vec3& place) const noexcept { return level_m + towards.dot(place); }

  bool is_behind(const PartWall& wall) const noexcept {
    return wall.normal.dot(corners.a) <= wall.offset_m && wall.normal.dot(corners.b) <= wall.offset_m &&
           wall.normal.dot(corners.c) <= wall.offset_m;
  }
  bool is_behind_any(std::span<const PartWall> walls) const noexcept {
    return std::any_of(walls.begin(), walls.end(), [this](const PartWall& wall) { return is_behind(wall); });
  }
};

}  // namespace fingerpad
