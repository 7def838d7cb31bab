#pragma once

#include "part/part.hpp"

namespace fingerpad {

/// The normal at corner k of triangle t that curved patches share over the smooth fan around it: the sum of
/// the fan's facet normals, each weighted with its angle at the corner times its area, unit.
///
/// The area lets a large flat face keep its own normal where it meets the narrow facets of a fillet, so that
/// it stays flat, to what the fillet's facets are wrong by anyway; Part::corner_normals (angle alone) tilt
/// there by half a facet's turn, and a patch over the flat face would rise by that tilt times its length. The
/// angle makes both triangles of a quad count as one facet, however it was split.
/// Fans of more than 64 triangles keep Part::corner_normals.
/// noexcept, allocates nothing; the same from every triangle of the fan, up to rounding.
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
