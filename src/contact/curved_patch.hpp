#pragma once

#include <array>

#include "contact/curved_normals.hpp"

namespace fingerpad {

/// A triangle's curved patch: a cubic Bezier triangle through its corners, there perpendicular to the corner
/// normals (PN triangle; Vlachos, Peters, Boyd & Mitchell 2001), and the normal shown over it, quadratic.
///
/// The patches of neighbours meet in one curve, as an edge's curve comes from what both sides know:
///   smooth edge: along the end points' tangent planes, as far as a circle's arc of the same turn has its
///   control points (Vlachos et al. project a third of the chord, which is less);
///   crease: at each end the tangent along which both sides' tangent planes meet, so that the edge stays
///   sharp and follows the design's curve; the edge of a box stays straight; straight where there is no
///   single neighbour, or where an end's tangent would turn off the chord by more than 30 degrees.
/// The shown normal is continuous too: over an edge it depends on the edge's two ends and its curve alone.
/// The patch's own normal is not (it steps by O(h^2) from patch to patch), so it is not shown.
struct CurvedPatch {
  /// Relative to the part's centre [m]: corners 0 1 2; edge 0 near corner 0, near 1; edge 1 near 1, near 2;
  /// edge 2 near 2, near 0; the middle.
  std::array<Vec3, 10> control;
  std::array<Vec3, 3> corner_normal;  ///< unit
  std::array<Vec3, 3> edge_normal;    ///< unit; half way along edge k
  double length_m = 0;                ///< longest edge
  double deviation_m = 0;             ///< the patch lies within this of its triangle (by its control points)
  bool flat = false;                  ///< it is the triangle, to 1e-9 of its length
};

/// A place on a patch and its derivatives by barycentric coordinates 1 and 2 (0 makes up for them).
struct PatchPoint {
  Vec3 x, x1, x2;      ///< [m]
  Vec3 x11, x12, x22;  ///< [m]
};

/// The patch over triangle t. noexcept, allocates nothing; finite for any part.
CurvedPatch curved_patch(const CornerNormals& normals, int t) noexcept;

PatchPoint evaluate(const CurvedPatch& patch, const Vec3& barycentric) noexcept;

/// The shown normal, unit; `otherwise` where it says nothing (a fold).
Vec3 shown_normal(const CurvedPatch& patch, const Vec3& barycentric, const Vec3& otherwise) noexcept;

}  // namespace fingerpad
