#pragma once

#include "part/part.hpp"

namespace fingerpad {

/// The normal at corner k of triangle t that curved patches share over the smooth fan around it, unit.
///
/// Where the edges of the fan are curved alike at both their ends, its vertices lie on one surface: each
/// facet counts as on a sphere (Max 1999), whatever the widths. So a cylinder's normals in strips are exact,
/// and a sphere's where the fan goes all the way round; a torus's are of second order. Elsewhere, as where a
/// fillet meets its face, wide facets count most: by their angle at the corner times their area. Between the
/// two the normal goes over smoothly (unevenness, curved_normals.cpp).
///
/// A fan that ends at a crease, or at the part's rim, has its facets on one side, towards which they lean:
/// its normal is told by the closed fans beside it, as far as these are sure (rim_normal,
/// curved_normals.cpp).
///
/// Beside a flat face (facets in one plane) of twice its area a fillet's first facet is left out: one beyond
/// which the surface turns on by nearly twice as much as from the face to it. So a flat face keeps its own
/// normal where it meets the facets of a fillet, a bore's wall that of its own strips, and the fillet's first
/// facet leaves along it. Part::corner_normals (angle alone) tilt there by half a facet's turn, and a patch
/// over the face would rise by a quarter of that tilt times its length. A face no wider than the facets
/// beside it is not looked at so, nor is a fillet of one facet. Fans of more than 64 triangles keep
/// Part::corner_normals.
///
/// noexcept, allocates nothing; the same bits from every triangle of the fan.
Vec3 curved_corner_normal(const Part& part, int t, int corner) noexcept;

/// That of every corner, 3 x 3n as Part::corner_normals. On all threads; the same bits on any number of them.
Points curved_corner_normals(const Part& part);

/// Where patches take their corner normals from: a table where there is one, else made when asked for. Either
/// way the same bits.
struct CornerNormals {
  const Part& part;
  const Points* table = nullptr;  ///< curved_corner_normals of the part

  Vec3 operator()(int t, int corner) const noexcept {
    if (table != nullptr) return table->col(Eigen::Index{3} * t + corner);
    return curved_corner_normal(part, t, corner);
  }
};

}  // namespace fingerpad
