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

inline TriangleCorners corners_of(const Part& part, int t) noexcept {
  return {part.vertices.col(part.triangles(0, t)), part.vertices.col(part.triangles(1, t)),
          part.vertices.col(part.triangles(2, t)), part.facet_normals.col(t)};
}

/// Whether a triangle is more than its edges: else no point of it counts as one of its face.
bool has_face(const TriangleCorners& triangle) noexcept;

/// The closest point of triangle t to q, relative to the part's centre, without the ties' bookkeeping of
/// closest_on_triangle: exact to rounding. noexcept, allocates nothing.
TriangleApproach approach_triangle(const Part& part, int t, const Vec3& q) noexcept;
TriangleApproach approach_triangle(const TriangleCorners& triangle, const Vec3& q) noexcept;

/// The same, where the closest point is on the face and no more than the point is wanted.
/// @param foot  written where it is
/// @returns     whether it is
bool find_foot_on_face(const Part& part, int t, const Vec3& q, Vec3& foot) noexcept;

/// The edge of triangle t, as Part::neighbours counts them, beyond which a place beside it lies: of two that
/// with the larger triangle between.
int edge_farthest_behind(const Part& part, int t, const Vec3& q) noexcept;

}  // namespace fingerpad
