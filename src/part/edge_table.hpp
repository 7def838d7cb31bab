#pragma once

#include <span>
#include <vector>

#include "base/types.hpp"

namespace fingerpad {

/// The edges of a triangle mesh, each with the half-edges on it.
///
/// Half-edge 3t + k runs from corner k of triangle t to corner k + 1 (mod 3). Triangles with two equal
/// corners are left out.
struct EdgeTable {
  std::vector<int> half_edges;  ///< those of one edge stand together, ascending
  std::vector<int> starts;  ///< edge e: half_edges[starts[e]] up to, not including, half_edges[starts[e + 1]]

  int edge_count() const { return static_cast<int>(starts.size()) - 1; }
  std::span<const int> on_edge(int e) const {
    const auto from = static_cast<std::size_t>(starts[static_cast<std::size_t>(e)]);
    const auto to = static_cast<std::size_t>(starts[static_cast<std::size_t>(e) + 1]);
    return {half_edges.data() + from, to - from};
  }
};

/// @param corners       3 x n, vertex numbers
/// @param vertex_count  above every number. O(n) for bounded valence.
EdgeTable make_edge_table(const IndexTriples& corners, int vertex_count);

inline int edge_from(const IndexTriples& corners, int half_edge) {
  return corners(half_edge % 3, half_edge / 3);
}
inline int edge_to(const IndexTriples& corners, int half_edge) {
  return corners((half_edge % 3 + 1) % 3, half_edge / 3);
}
/// The corner of the half-edge's triangle that is not on the edge.
inline int edge_opposite(const IndexTriples& corners, int half_edge) {
  return corners((half_edge % 3 + 2) % 3, half_edge / 3);
}
/// Whether two corners are one vertex.
inline bool is_collapsed(const IndexTriples& corners, int t) {
  return corners(0, t) == corners(1, t) || corners(1, t) == corners(2, t) || corners(2, t) == corners(0, t);
}

/// What the edges say about the mesh.
struct EdgeCounts {
  long boundary = 0;      ///< edges of one triangle
  long nonmanifold = 0;   ///< edges of more than two
  long inconsistent = 0;  ///< manifold edges that both triangles pass in the same direction
};
EdgeCounts count_edges(const EdgeTable& table, const IndexTriples& corners);

/// Components connected over edges: a number from 0 for each triangle, by first appearance; -1 for triangles
/// that are not in the table.
std::vector<int> component_of(const EdgeTable& table, int triangle_count, int* component_count);

/// How many components there are when a common vertex is enough to connect.
int component_count(const IndexTriples& corners, int vertex_count);

/// Triangles with the same three vertices as an earlier one, in either winding.
std::vector<bool> find_duplicates(const EdgeTable& table, const IndexTriples& corners);

}  // namespace fingerpad
