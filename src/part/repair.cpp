#include "part/repair.hpp"

#include <algorithm>
#include <utility>

#include "part/index.hpp"

namespace fingerpad {
namespace {

/// The triangles across edges of two.
struct AcrossPairs {
  IndexTriples triangle;       ///< 3 x n, -1 where there is no single one
  std::vector<bool> same_way;  ///< 3n: both pass the edge in the same direction, so that one must be turned
};

AcrossPairs across_edges(const EdgeTable& edges, const IndexTriples& corners) {
  AcrossPairs across;
  across.triangle = IndexTriples::Constant(3, corners.cols(), -1);
  across.same_way.assign(at(static_cast<int>(corners.size())), false);
  for (int e = 0; e < edges.edge_count(); ++e) {
    const auto on = edges.on_edge(e);
    if (on.size() != 2) continue;
    const bool same_way = edge_from(corners, on[0]) == edge_from(corners, on[1]);
    for (const int i : {0, 1}) {
      across.triangle.reshaped()[on[at(i)]] = on[at(1 - i)] / 3;
      across.same_way[at(on[at(i)])] = same_way;
    }
  }
  return across;
}

}  // namespace

std::vector<bool> turns_to_one_way(const EdgeTable& edges, const IndexTriples& corners) {
  const int n = static_cast<int>(corners.cols());
  std::vector<bool> turned(at(n), false), seen(at(n), false);
  if (count_edges(edges, corners).inconsistent == 0) return turned;
  const AcrossPairs across = across_edges(edges, corners);
  std::vector<int> piece;
  for (int start = 0; start < n; ++start) {
    if (seen[at(start)]) continue;
    seen[at(start)] = true;
    piece.assign(1, start);
    std::size_t turns = 0;
    for (std::size_t next = 0; next < piece.size(); ++next) {
      const int t = piece[next];
      for (int k = 0; k < 3; ++k) {
        const int other = across.triangle(k, t);
        if (other < 0 || seen[at(other)]) continue;
        seen[at(other)] = true;
        turned[at(other)] = turned[at(t)] != across.same_way[at(3 * t + k)];
        turns += turned[at(other)] ? 1 : 0;
        piece.push_back(other);
      }
    }
    if (2 * turns <= piece.size()) continue;
    for (const int t : piece) turned[at(t)] = !turned[at(t)];
  }
  return turned;
}

void turn(IndexTriples& corners, const std::vector<bool>& turned) {
  for (int t = 0; t < corners.cols(); ++t) {
    if (turned[at(t)]) std::swap(corners(1, t), corners(2, t));
  }
}

EdgeTable wind(const Points& vertices, IndexTriples& triangles, IndexTriples& welded, int welded_count,
               EdgeTable edges, RepairCounts& counts) {
  std::vector<bool> turned = turns_to_one_way(edges, welded);
  counts.turned_triangles += std::count(turned.begin(), turned.end(), true);
  const auto turn_all = [&] {
    if (std::find(turned.begin(), turned.end(), true) == turned.end()) return;
    turn(triangles, turned);
    turn(welded, turned);
    edges = make_edge_table(welded, welded_count);
  };
  turn_all();
  const Bodies bodies = find_bodies(vertices, triangles, welded, edges);
  counts.nesting_unknown = !bodies.depths_known;
  for (const Body& body : bodies.all) {
    if (bodies.is_inside_out(body)) ++(body.depth % 2 == 0 ? counts.turned_bodies : counts.turned_cavities);
  }
  for (int t = 0; t < triangles.cols(); ++t) {
    const int body = bodies.of_triangle[at(t)];
    turned[at(t)] = body >= 0 && bodies.is_inside_out(bodies.all[at(body)]);
  }
  turn_all();
  return edges;
}

}  // namespace fingerpad
