#include "part/connected_mesh.hpp"

#include <algorithm>

#include "part/index.hpp"
#include "part/repair.hpp"
#include "part/weld.hpp"

namespace fingerpad {
namespace {

IndexTriples welded_corners(const IndexTriples& triangles, const Welding& welding) {
  return triangles.unaryExpr([&](int v) { return welding.id[at(v)]; });
}

int collapsed_count(const IndexTriples& corners) {
  int count = 0;
  for (int t = 0; t < corners.cols(); ++t) count += is_collapsed(corners, t) ? 1 : 0;
  return count;
}

Connected connected(const Centred& mesh, const Welding& welding) {
  Connected result;
  result.welded = welded_corners(mesh.triangles, welding);
  result.welded_count = welding.count;
  result.edges = make_edge_table(result.welded, welding.count);
  result.counts = count_edges(result.edges, result.welded);
  return result;
}

/// The farthest that vertices may lie apart and be taken as one.
double weld_reach(const Centred& mesh) {
  return 1e-7 * 2 * mesh.half_extent.norm();
}

}  // namespace

Centred centred(const TriangleSoup& soup, const std::vector<int>& kept) {
  Centred result;
  std::vector<int> number(at(static_cast<int>(soup.vertices_P.cols())), -1);
  std::vector<int> used;
  result.triangles.resize(3, static_cast<Eigen::Index>(kept.size()));
  for (std::size_t t = 0; t < kept.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const int v = soup.triangles(k, kept[t]);
      if (number[at(v)] < 0) {
        number[at(v)] = static_cast<int>(used.size());
        used.push_back(v);
      }
      result.triangles(k, static_cast<Eigen::Index>(t)) = number[at(v)];
    }
  }
  result.points.resize(3, static_cast<Eigen::Index>(used.size()));
  for (std::size_t i = 0; i < used.size(); ++i) {
    result.points.col(static_cast<Eigen::Index>(i)) = soup.vertices_P.col(used[i]);
  }
  if (used.empty()) return result;
  const Vec3 low = result.points.rowwise().minCoeff(), high = result.points.rowwise().maxCoeff();
  result.centre_P = 0.5 * low + 0.5 * high;
  result.half_extent = 0.5 * high - 0.5 * low;
  result.largest_coordinate = std::max(low.cwiseAbs().maxCoeff(), high.cwiseAbs().maxCoeff());
  result.points.colwise() -= result.centre_P;
  return result;
}

Connected weld_all(const Centred& mesh, RepairCounts& counts) {
  const Welding equal = weld_equal(mesh.points);
  const double reach = weld_reach(mesh);
  std::vector<int> one_of_each;
  for (std::size_t i = 0; i < equal.id.size(); ++i) {
    if (equal.id[i] == static_cast<int>(one_of_each.size())) one_of_each.push_back(static_cast<int>(i));
  }
  const Welding near = reach > 0 ? weld_near(mesh.points, equal, one_of_each, reach) : equal;
  counts.welded_vertices = equal.count - near.count;
  Connected result = connected(mesh, near);
  if (near.count < equal.count) result.weld_distance = reach;
  return result;
}

Connected weld(const Centred& mesh) {
  const Welding equal = weld_equal(mesh.points);
  Connected first = connected(mesh, equal);
  const double reach = weld_reach(mesh);
  if (first.counts.boundary == 0 || !(reach > 0)) return first;
  std::vector<int> candidates;
  std::vector<bool> listed(at(equal.count), false);
  for (int e = 0; e < first.edges.edge_count(); ++e) {
    const auto on = first.edges.on_edge(e);
    if (on.size() != 1) continue;
    for (const int corner : {on[0] % 3, (on[0] % 3 + 1) % 3}) {
      const int point = mesh.triangles(corner, on[0] / 3);
      if (listed[at(equal.id[at(point)])]) continue;
      listed[at(equal.id[at(point)])] = true;
      candidates.push_back(point);
    }
  }
  Connected second = connected(mesh, weld_near(mesh.points, equal, candidates, reach));
  const bool closes = second.counts.boundary == 0 && second.counts.nonmanifold <= first.counts.nonmanifold &&
                      collapsed_count(second.welded) == collapsed_count(first.welded);
  if (!closes) return first;
  second.weld_distance = reach;
  return second;
}

}  // namespace fingerpad
