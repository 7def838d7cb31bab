#pragma once

#include <utility>

#include "contact/closest_point.hpp"

namespace fingerpad {

// What the facets alone say of a place on them: its normal, which way is out, whether it is smooth there.

/// Closer than this fraction of the part's size the direction to the finger is rounding, not geometry.
inline constexpr double direction_resolution = 1e-9;
/// Unit vectors this near are the same, up to the rounding that made them.
inline constexpr double same_normal2 = 1e-18;

inline int corner_of(Feature feature) noexcept {
  return static_cast<int>(feature) - static_cast<int>(Feature::vertex0);
}
inline int edge_of(Feature feature) noexcept {
  return static_cast<int>(feature) - static_cast<int>(Feature::edge0);
}
inline bool is_edge(Feature feature) noexcept {
  return feature >= Feature::edge0 && feature <= Feature::edge2;
}

/// Angle-weighted, unit; the side of it that a point is on says whether it is inside.
inline Vec3 pseudonormal(const Part& part, int t, Feature feature) noexcept {
  if (feature == Feature::face) return part.facet_normals.col(t);
  if (is_edge(feature)) return part.edge_pseudonormals.col(3 * t + edge_of(feature));
  return part.vertex_pseudonormals.col(part.welded(corner_of(feature), t));
}

inline bool has_crease(const Part& part, int t, int edge) noexcept {
  return (part.creases[t] >> edge & 1) != 0;
}

/// The corner of the triangle beyond edge k of triangle t that is not on the edge.
inline int corner_beyond(const Part& part, int t, int k, int other) noexcept {
  const int a = part.welded(k, t), b = part.welded((k + 1) % 3, t);
  int j = 0;
  while (j < 2 && (part.welded(j, other) == a || part.welded(j, other) == b)) ++j;
  return j;
}

/// A triangle at a vertex, and the one of its two edges there over which one goes on about the vertex.
struct VertexTurn {
  int vertex;  ///< welded
  int triangle, edge;

  /// The triangle beyond the edge; -1 at an open rim.
  int next(const Part& part) const noexcept { return part.neighbours(edge, triangle); }
  /// Of the triangle, at the vertex.
  int corner(const Part& part) const noexcept {
    return part.welded(edge, triangle) == vertex ? edge : (edge + 1) % 3;
  }
  /// @pre next(part) >= 0
  void go_on(const Part& part) noexcept {
    const int before = std::exchange(triangle, next(part));
    int corner = 0;
    while (corner < 2 && part.welded(corner, triangle) != vertex) ++corner;
    // Of the two edges at the vertex, the one not come by.
    edge = part.neighbours(corner, triangle) == before ? (corner + 2) % 3 : corner;
  }
};

/// Whether the triangles around a corner close a ring: not at the border of an open part. Fans of more than
/// 64 count as closed.
inline bool is_ringed(const Part& part, int t, int corner) noexcept {
  VertexTurn at{part.welded(corner, t), t, corner};
  for (int turn = 0; turn < 64; ++turn) {
    const int next = at.next(part);
    if (next < 0 || next == t) return next == t;
    at.go_on(part);
  }
  return true;
}

/// Whether the surface is smooth at a feature, so that normals other than the facets' may be shown there.
inline bool is_smooth(const Part& part, int t, Feature feature) noexcept {
  if (feature == Feature::face) return true;
  if (is_edge(feature)) return !has_crease(part, t, edge_of(feature));
  const int corner = corner_of(feature);
  if (has_crease(part, t, corner) || has_crease(part, t, (corner + 2) % 3)) return false;
  const Vec3 all_round = part.vertex_pseudonormals.col(part.welded(corner, t));
  return (part.corner_normals.col(3 * t + corner) - all_round).squaredNorm() <= same_normal2 &&
         is_ringed(part, t, corner);
}

/// Whether both facets at an edge lie in one plane.
inline bool is_flat_edge(const Part& part, int t, int edge) noexcept {
  const int other = part.neighbours(edge, t);
  return other >= 0 &&
         (part.facet_normals.col(t) - part.facet_normals.col(other)).squaredNorm() <= same_normal2;
}

/// The gradient of the signed distance to the facets.
/// @param outward  from the surface point to the finger, or its opposite where the finger is inside
inline Vec3 facet_normal(const Part& part, int t, Feature feature, const Vec3& pseudonormal,
                         const Vec3& outward, double distance_m) noexcept {
  if (feature == Feature::face || distance_m <= direction_resolution * part.size_m()) return pseudonormal;
  if (is_edge(feature) && is_flat_edge(part, t, edge_of(feature))) return pseudonormal;
  return outward / distance_m;
}

}  // namespace fingerpad
