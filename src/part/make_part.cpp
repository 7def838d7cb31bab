#include <algorithm>
#include <utility>

#include "part/build_part.hpp"
#include "part/edge_table.hpp"
#include "part/normals.hpp"
#include "part/volume.hpp"
#include "part/weld.hpp"

namespace fingerpad {
namespace {

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

/// Points and triangles with unused points gone and the centre taken out.
struct Centred {
  Vec3 centre_P = Vec3::Zero(), half_extent = Vec3::Zero();
  double largest_coordinate = 0;  // in frame P
  Points points;
  IndexTriples triangles;
};

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

IndexTriples welded_corners(const IndexTriples& triangles, const Welding& welding) {
  return triangles.unaryExpr([&](int v) { return welding.id[at(v)]; });
}

int collapsed_count(const IndexTriples& corners) {
  int count = 0;
  for (int t = 0; t < corners.cols(); ++t) count += is_collapsed(corners, t) ? 1 : 0;
  return count;
}

/// Who is connected with whom.
struct Connected {
  IndexTriples welded;
  int welded_count = 0;
  EdgeTable edges;
  EdgeCounts counts;
  double weld_distance = 0;
};

Connected connected(const Centred& mesh, const Welding& welding) {
  Connected result;
  result.welded = welded_corners(mesh.triangles, welding);
  result.welded_count = welding.count;
  result.edges = make_edge_table(result.welded, welding.count);
  result.counts = count_edges(result.edges, result.welded);
  return result;
}

/// Welds equal vertices; where that leaves boundary edges, those on them also at 1e-7 of the diagonal. The
/// second is kept only where it closes the mesh and neither collapses a triangle nor makes an edge
/// non-manifold.
Connected weld(const Centred& mesh) {
  const Welding equal = weld_equal(mesh.points);
  Connected first = connected(mesh, equal);
  const double reach = 1e-7 * 2 * mesh.half_extent.norm();
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

IndexTriples neighbours_of(const EdgeTable& edges, int triangle_count) {
  IndexTriples neighbours = IndexTriples::Constant(3, triangle_count, -1);
  for (int e = 0; e < edges.edge_count(); ++e) {
    const auto on = edges.on_edge(e);
    if (on.size() != 2) continue;
    neighbours(on[0] % 3, on[0] / 3) = on[1] / 3;
    neighbours(on[1] % 3, on[1] / 3) = on[0] / 3;
  }
  return neighbours;
}

std::vector<bool> without_area(const Centred& mesh) {
  std::vector<bool> flat(at(static_cast<int>(mesh.triangles.cols())));
  for (int t = 0; t < mesh.triangles.cols(); ++t) {
    flat[at(t)] = has_no_area(shape_of(mesh.points, mesh.triangles, t), mesh.largest_coordinate);
  }
  return flat;
}

/// The triangles `kept` (of the soup) as a part with neighbours and facet normals; the welding is inherited.
/// @param welded_ids  3 x all triangles of the soup
Part assembled(const TriangleSoup& soup, const std::vector<int>& kept, const IndexTriples& welded_ids,
               EdgeTable& edges, std::vector<bool>& flat) {
  const Centred mesh = centred(soup, kept);
  Part part;
  part.centre_P = mesh.centre_P;
  part.half_extent = mesh.half_extent;
  part.vertices = mesh.points;
  part.triangles = mesh.triangles;
  part.welded.resize(3, part.triangles.cols());
  std::vector<int> number(welded_ids.size() == 0 ? 0 : at(welded_ids.maxCoeff()) + 1, -1);
  for (int t = 0; t < part.triangle_count(); ++t) {
    const int in_soup = kept[at(t)];
    part.file_triangle.push_back(soup.file_triangle.empty() ? in_soup : soup.file_triangle[at(in_soup)]);
    for (int k = 0; k < 3; ++k) {
      int& id = number[at(welded_ids(k, in_soup))];
      if (id < 0) id = part.welded_count++;
      part.welded(k, t) = id;
    }
  }
  edges = make_edge_table(part.welded, part.welded_count);
  flat = without_area(mesh);
  part.neighbours = neighbours_of(edges, part.triangle_count());
  part.facet_normals = facet_normals(part, edges, flat);
  return part;
}

/// Counts what the whole soup holds and lists what goes into the part.
std::vector<int> take_census(const Centred& mesh, const Connected& whole, Census& census) {
  const int n = static_cast<int>(mesh.triangles.cols());
  const std::vector<bool> duplicate = find_duplicates(whole.edges, whole.welded);
  const std::vector<bool> flat = without_area(mesh);
  component_of(whole.edges, n, &census.components);
  census.boundary_edges = whole.counts.boundary;
  census.nonmanifold_edges = whole.counts.nonmanifold;
  census.inconsistent_edges = whole.counts.inconsistent;
  census.weld_distance_m = whole.weld_distance;
  std::vector<int> kept;
  kept.reserve(at(n));
  for (int t = 0; t < n; ++t) {
    const bool collapsed = is_collapsed(whole.welded, t);
    if (collapsed || flat[at(t)]) ++census.degenerate;
    if (duplicate[at(t)]) ++census.duplicate;
    if (!collapsed && !duplicate[at(t)]) kept.push_back(t);
  }
  return kept;
}

}  // namespace

BuiltPart build_part(const TriangleSoup& soup, double crease_rad) {
  BuiltPart built;
  std::vector<int> kept(at(static_cast<int>(soup.triangles.cols())));
  for (std::size_t t = 0; t < kept.size(); ++t) kept[t] = static_cast<int>(t);
  IndexTriples welded_ids;
  {
    const Centred mesh = centred(soup, kept);
    Connected whole = weld(mesh);
    kept = take_census(mesh, whole, built.census);
    welded_ids = std::move(whole.welded);
  }
  EdgeTable edges;
  std::vector<bool> flat;
  Part& part = built.part;
  part = assembled(soup, kept, welded_ids, edges, flat);
  // Triangles without area that no edge joins to one with area have no side: they go too.
  std::vector<int> sided;
  for (int t = 0; t < part.triangle_count(); ++t) {
    if (!part.facet_normals.col(t).isZero(0)) sided.push_back(kept[at(t)]);
  }
  if (sided.size() < kept.size()) part = assembled(soup, sided, welded_ids, edges, flat);
  fill_edge_pseudonormals(part, edges, flat);
  fill_vertex_pseudonormals(part);
  fill_creases(part, crease_rad);
  fill_corner_normals(part);
  measure_bodies(part, edges, built.census);
  return built;
}

Part make_part(const TriangleSoup& soup, double crease_rad, double* weld_distance_m) {
  BuiltPart built = build_part(soup, crease_rad);
  if (weld_distance_m != nullptr) *weld_distance_m = built.census.weld_distance_m;
  return std::move(built.part);
}

Bounds bounds_P(const Part& part) {
  return {part.centre_P - part.half_extent, part.centre_P + part.half_extent};
}

}  // namespace fingerpad
