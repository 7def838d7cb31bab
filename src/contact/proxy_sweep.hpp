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

/// Whether a ball on its way meets a triangle, with a half space as the witness.
struct TriangleSweep {
  bool blocked = false;
  Vec3 normal = Vec3::UnitZ();  ///< where blocked: unit; every place q with normal . q >= offset_m keeps the
                                ///< clearance, and the way's start is one
  double offset_m = 0;
  double end_slack_m = 0;  ///< normal . to - offset_m
  double reached = 1;      ///< share of the way that is free
};

/// Sweeps a ball of radius `clearance_m` from `from` to `to` past a triangle, from whichever side.
///
/// The distance to a triangle is a convex function of the way, so Newton's method from the start never
/// passes the place of first touch, and each of its tangents is the half space that the triangle leaves
/// free: either one shows the rest of the way free, or the steps end at the touch. There the tangent half
/// space is the wall, or the facet's own where that holds the ball back less.
/// @param tolerance_m  by how much the clearance may be missed, > 0
/// @pre from has the clearance, to within a few tolerances. noexcept, allocates nothing.
TriangleSweep sweep_past_triangle(const TriangleCorners& triangle, const Vec3& from, const Vec3& to,
                                  double clearance_m, double tolerance_m) noexcept;

}  // namespace fingerpad
