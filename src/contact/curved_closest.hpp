#pragma once

#include "contact/curved_patch.hpp"
#include "contact/triangle_tree.hpp"

namespace fingerpad {

/// The closest point of a part's curved surface.
struct CurvedPoint {
  int triangle = -1;  ///< whose patch it lies on
  TrianglePoint
      at;  ///< relative to the part's centre; its place in the triangle is that of the patch's parameters
  Vec3 normal_P = Vec3::UnitZ();  ///< shown_normal there
  double deviation_m = 0;         ///< patches looked at lie within this of their triangles
};

/// The point of the curved surface that is closest to q, sought downhill from the facets' answer: by Newton's
/// method on the patch (at most 24 steps), kept within its triangle, and on to the neighbour over an edge or
/// around a vertex as long as it comes nearer (at most 12 times). Depends on q and the facets' answer alone.
///
/// Where several places are locally closest this is the one downhill from the facets' answer, so a jump of
/// the facets' closest point from sheet to sheet is one here. Where Newton's method fails (a folded patch, a
/// triangle without area, a point at infinity), it is the facets' answer.
/// @param facets  the tree's answer for q, found
/// noexcept, allocates nothing.
CurvedPoint closest_on_curved(const CornerNormals& normals, const ClosestTriangle& facets,
                              const Vec3& q) noexcept;

}  // namespace fingerpad
