#pragma once

#include "contact/closest_point.hpp"

namespace fingerpad {

/// How a point stands before a triangle, from whichever side.
struct TriangleApproach {
  TrianglePoint at;              ///< closest point of the triangle
  Vec3 towards = Vec3::UnitZ();  ///< unit, from there to the point; over the face the facet's normal, turned
                                 ///< to the point's side
  double distance_m = 0;
};

/// A triangle at hand: what the sweeps read of a part.
struct TriangleCorners {
  Vec3 a, b, c;  ///< relative to the part's centre [m]
  Vec3 normal;   ///< Part::facet_normals
};

TriangleCorners corners_of(const Part& part, int t) noexcept;

/// The closest point of triangle t to q, relative to the part's centre, without the ties' bookkeeping of
/// closest_on_triangle: exact to rounding. noexcept, allocates nothing.
TriangleApproach approach_triangle(const Part& part, int t, const Vec3& q) noexcept;
TriangleApproach approach_triangle(const TriangleCorners& triangle, const Vec3& q) noexcept;

}  // namespace fingerpad
