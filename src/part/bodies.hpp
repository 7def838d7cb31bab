#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "part/edge_table.hpp"

namespace fingerpad {

/// Triangles connected over edges that no more than two share.
struct Body {
  double volume_m3 = 0;     ///< signed, about the origin of the points; of meaning where closed
  Eigen::AlignedBox3d box;  ///< [m]
  bool closed = true;       ///< it passes every edge as often one way as the other: it bounds a solid
  int depth = 0;            ///< how many other closed bodies it lies in; 0 where not closed
};

struct Bodies {
  std::vector<int> of_triangle;  ///< the body of each triangle, numbered by first appearance; -1: collapsed
  std::vector<Body> all;
  bool depths_known = true;  ///< false: so many bodies overlap that nobody counted

  /// Whether a closed body is wound against its depth: outer shells and solids in cavities outwards, cavities
  /// inwards.
  bool is_inside_out(const Body& body) const {
    return body.closed && (body.volume_m3 < 0) == (body.depth % 2 == 0);
  }
};

/// Finds the bodies and which lie inside which, by counting the closed bodies' sheets above three facet
/// centres of each (the majority counts). O(n) for bodies side by side; so many that overlap that it would
/// take minutes are left without depths.
/// @param welded  3 x n, as triangles with equal vertices merged; `edges` is its table
/// @pre no two triangles repeat each other
Bodies find_bodies(const Points& vertices, const IndexTriples& triangles, const IndexTriples& welded,
                   const EdgeTable& edges);

}  // namespace fingerpad
