#pragma once

#include "contact/closest_memory.hpp"
#include "touch/world.hpp"

namespace fingerpad {

/// Where a point stands against one surface of a world, frame W.
struct WorldPoint {
  Vec3 point_W = Vec3::Zero();    ///< S [m]
  Vec3 normal_W = Vec3::UnitZ();  ///< outward, unit
  double signed_distance_m = std::numeric_limits<double>::infinity();
  int triangle = -1;   ///< index into Part::triangles, the next search's seed; -1 for a plane
  bool found = false;  ///< something lies within reach, or the point is inside
};

/// The nearest point of a surface to p_WQ. `found` is false where the surface is farther than reach_m; for a
/// part a point outside its padded bounding box is told so without a search.
/// @pre p_WQ finite. noexcept, allocates nothing.
WorldPoint nearest_point(const Surface& surface, const Vec3& p_WQ, Normals normals, int seed,
                         double reach_m) noexcept;

/// The same along a path; see TriangleTree::closest.
WorldPoint nearest_point(const Surface& surface, const Vec3& p_WQ, Normals normals, ClosestMemory& memory,
                         double reach_m) noexcept;

/// The point under p_WQ of triangle t's facet or the next; see point_on_facet.
WorldPoint nearest_on_facet(const Surface& surface, int t, const Vec3& p_WQ, Normals normals) noexcept;

}  // namespace fingerpad
