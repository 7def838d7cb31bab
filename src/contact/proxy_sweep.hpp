#pragma once

#include "contact/triangle_approach.hpp"

namespace fingerpad {

/// Whether a ball on its way meets a triangle, with a half space as the witness.
struct TriangleSweep {
  bool blocked = false;
  Vec3 normal = Vec3::UnitZ();  ///< where blocked: unit; every place q with normal . q >= offset_m keeps the
                                ///< clearance, and the way's start is one
  double offset_m = 0;
  double end_slack_m = 0;  ///< normal . to - offset_m, or FacetSide::slack_m where that is more
  double free_share = 1;   ///< of the way, from its start
  int steps = 0;           ///< of Newton's method
};

/// What a sweep begins with: of a TriangleApproach, what it reads.
struct FirstApproach {
  Vec3 foot, towards;
  double distance_m;

  FirstApproach() = default;
  explicit FirstApproach(const TriangleApproach& approach) noexcept
      : foot(approach.at.point), towards(approach.towards), distance_m(approach.distance_m) {}
};

/// The half space on the start's side of a triangle's own plane, where the ball keeps its clearance from it.
struct FacetSide {
  double side = 0;     ///< 1 on the normal's, -1; 0: the start is too near, or the triangle has no plane
  double slack_m = 0;  ///< how far in front of it the way ends
};

/// A sweep whose start has such a side ends no farther behind than that: what it leaves free needs no sweep.
FacetSide facet_side(const TriangleCorners& triangle, const Vec3& from, const Vec3& to, double clearance_m,
                     double tolerance_m) noexcept;

/// Sweeps a ball of radius `clearance_m` from `from` to `to` past a triangle, from whichever side.
///
/// The distance to a triangle is a convex function of the way, so Newton's method from the start never
/// passes the place of first touch, and each of its tangents is the half space that the triangle leaves
/// free: either one shows the rest of the way free, or the steps end at the touch. There the tangent half
/// space is the wall, or the facet's own where that holds the ball back less and the ball touches that side.
/// @param tolerance_m  by how much the clearance may be missed, > 0
/// @param first    how `from` stands before the triangle: approach_triangle(triangle, from)
/// @param worst_m  blocked only if end_slack_m is no greater than this: tangents only rise along the way, so
/// that most sweeps end early
/// @pre from has the clearance, to within a few tolerances. noexcept, allocates nothing.
TriangleSweep sweep_past_triangle(const TriangleCorners& triangle, const Vec3& from, const Vec3& to,
                                  double clearance_m, double tolerance_m, const FirstApproach& first,
                                  double worst_m) noexcept;

}  // namespace fingerpad
