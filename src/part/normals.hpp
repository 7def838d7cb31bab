#pragma once

#include <span>
#include <vector>

#include "part/edge_table.hpp"
#include "part/part.hpp"

namespace fingerpad {

/// The area vector of triangle t (half the cross product of two edges, outwards by the winding) and its
/// longest edge. The two shorter edges are crossed, which loses the least on slivers.
struct TriangleShape {
  Vec3 area = Vec3::Zero();  ///< [m^2]
  int longest_edge = 0;      ///< k: from corner k to corner k + 1
  double longest = 0;        ///< its length [m]
};
TriangleShape shape_of(const Points& vertices, const IndexTriples& triangles, int t);

/// Whether the triangle's height over its longest edge is no more than what rounding coordinates of this size
/// can make.
/// @param largest_coordinate  of the mesh, as absolute value
bool has_no_area(const TriangleShape& shape, double largest_coordinate);

/// Facet normals, unit: of a triangle without area that of the neighbour across its longest edge, because
/// that is the surface which its middle vertex stands on (or else of its largest neighbour); zero where no
/// edge joins it to one.
Points facet_normals(const Points& vertices, const IndexTriples& triangles, const EdgeTable& edges,
                     const std::vector<bool>& flat);

/// Fills edge_pseudonormals from facet_normals: the sum over all triangles at the edge. Across a triangle
/// without area stands the facet beyond it. Where the sum vanishes: the triangle's own facet normal.
void fill_edge_pseudonormals(Part& part, const EdgeTable& edges, const std::vector<bool>& flat);

/// The corners at each welded vertex: column 3 t + k is corner k of triangle t.
struct CornersAtVertices {
  std::vector<int> columns;  ///< those of one vertex stand together, ascending
  std::vector<int> starts;   ///< vertex v: columns[starts[v]] up to, not including, columns[starts[v + 1]]

  std::span<const int> at(int v) const {
    const auto from = static_cast<std::size_t>(starts[static_cast<std::size_t>(v)]);
    const auto to = static_cast<std::size_t>(starts[static_cast<std::size_t>(v) + 1]);
    return {columns.data() + from, to - from};
  }
};
CornersAtVertices corners_at_vertices(const Part& part);

/// Fills vertex_pseudonormals: angle-weighted sums (Baerentzen & Aanaes 2005); where one vanishes, the facet
/// normal of the lowest triangle there.
void fill_vertex_pseudonormals(Part& part, const CornersAtVertices& corners, const Points& angles);

/// Fills creases from facet_normals and neighbours.
void fill_creases(Part& part, double crease_rad);

/// Fills corner_normals: angle-weighted over the fan of triangles around the corner that no crease parts.
void fill_corner_normals(Part& part, const CornersAtVertices& corners, const Points& angles);

/// The angles at the corners [rad], 3 x n: row k is corner k.
Points corner_angles(const Part& part);

}  // namespace fingerpad
