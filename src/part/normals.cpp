#include "part/normals.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "base/large_pages.hpp"
#include "part/in_parallel.hpp"
#include "part/index.hpp"

namespace fingerpad {
namespace {

/// A sum of unit normals shorter than this points nowhere: its direction is rounding.
constexpr double vanishing = 1e-12;

/// Which edge each half-edge is on; -1 where on none.
std::vector<int> edge_of_half_edges(const EdgeTable& edges, int triangle_count) {
  std::vector<int> edge_of(at(3 * triangle_count), -1);
  for (int e = 0; e < edges.edge_count(); ++e) {
    for (const int h : edges.on_edge(e)) edge_of[at(h)] = e;
  }
  return edge_of;
}

/// The facets across the edges of the mesh's triangles.
class Across {
 public:
  /// @param triangle_count  0: nothing will be asked
  Across(const EdgeTable& edges, int triangle_count) : edges_(edges) {
    if (triangle_count > 0) edge_of_ = edge_of_half_edges(edges, triangle_count);
  }

  /// Visits the other triangles at half-edge h; none where more meet than a solid's sheets ever do, or
  /// thousands that all share one edge would each visit all others.
  template <typename Visit>
  void visit(int h, Visit&& visit) const {
    constexpr std::size_t crowded = 100;
    if (edge_of_[at(h)] < 0) return;
    const auto on = edges_.on_edge(edge_of_[at(h)]);
    if (on.size() > crowded) return;
    for (const int other : on) {
      if (other != h) visit(other / 3);
    }
  }

 private:
  const EdgeTable& edges_;
  std::vector<int> edge_of_;
};

/// Of each edge the largest triangle that has a normal, the lowest of equals: who gives its normal to those
/// without.
class Givers {
 public:
  Givers(const Points& vertices, const IndexTriples& triangles, const EdgeTable& edges)
      : vertices_(vertices),
        triangles_(triangles),
        edge_of_(edge_of_half_edges(edges, static_cast<int>(triangles.cols()))),
        of_edge_(at(edges.edge_count())) {}

  /// Triangle t has a normal to give.
  void add(int t) {
    const double area = shape_of(vertices_, triangles_, t).area.norm();
    for (int h = 3 * t; h < 3 * t + 3; ++h) {
      if (edge_of_[at(h)] < 0) continue;
      Giver& giver = of_edge_[at(edge_of_[at(h)])];
      if (area > giver.area || (area == giver.area && t < giver.triangle)) giver = {t, area};
    }
  }

  /// The largest triangle with a normal across these edges of t, which has none; or -1.
  int largest_across(int t, bool only_longest) const {
    Giver best;
    const int longest = shape_of(vertices_, triangles_, t).longest_edge;
    for (int k = 0; k < 3; ++k) {
      const int edge = edge_of_[at(3 * t + k)];
      if (edge < 0 || (only_longest && k != longest)) continue;
      if (of_edge_[at(edge)].area > best.area) best = of_edge_[at(edge)];
    }
    return best.triangle;
  }

 private:
  struct Giver {
    int triangle = -1;
    double area = -1;
  };

  const Points& vertices_;
  const IndexTriples& triangles_;
  std::vector<int> edge_of_;
  std::vector<Giver> of_edge_;
};

}  // namespace

TriangleShape shape_of(const Points& vertices, const IndexTriples& triangles, int t) {
  TriangleShape shape;
  std::array<Vec3, 3> edge;
  for (int k = 0; k < 3; ++k) {
    edge[at(k)] = vertices.col(triangles((k + 1) % 3, t)) - vertices.col(triangles(k, t));
    if (edge[at(k)].norm() <= shape.longest) continue;
    shape.longest = edge[at(k)].norm();
    shape.longest_edge = k;
  }
  shape.area = 0.5 * edge[at((shape.longest_edge + 1) % 3)].cross(edge[at((shape.longest_edge + 2) % 3)]);
  return shape;
}

bool has_no_area(const TriangleShape& shape, double largest_coordinate) {
  const double height = shape.longest > 0 ? 2 * shape.area.norm() / shape.longest : 0;
  return height <= 4 * std::numeric_limits<double>::epsilon() * largest_coordinate;
}

Points facet_normals(const Points& vertices, const IndexTriples& triangles, const EdgeTable& edges,
                     const std::vector<bool>& flat) {
  const int n = static_cast<int>(triangles.cols());
  Points normals(3, n);
  prefer_large_pages(normals);
  in_parallel(n, [&](int begin, int end) {
    for (int t = begin; t < end; ++t) {
      normals.col(t) = flat[at(t)] ? Vec3::Zero() : Vec3(shape_of(vertices, triangles, t).area.normalized());
    }
  });
  std::vector<int> waiting;
  for (int t = 0; t < n; ++t) {
    if (flat[at(t)]) waiting.push_back(t);
  }
  if (waiting.empty()) return normals;
  Givers givers(vertices, triangles, edges);
  for (int t = 0; t < n; ++t) {
    if (!normals.col(t).isZero(0)) givers.add(t);
  }
  // First across longest edges as far as that reaches, then one step across any edge, and again.
  bool only_longest = true;
  constexpr int many_rounds = 200;  // a strip of seams is done in a few, as every round turns back
  for (int round = 0; round < many_rounds && !waiting.empty(); ++round) {
    std::vector<int> still;
    for (const int t : waiting) {
      const int giver = givers.largest_across(t, only_longest);
      if (giver < 0) {
        still.push_back(t);
      } else {
        normals.col(t) = normals.col(giver);
        givers.add(t);
      }
    }
    const bool stuck = still.size() == waiting.size();
    if (stuck && !only_longest) break;
    only_longest = !stuck;
    waiting.assign(still.rbegin(), still.rend());
  }
  return normals;
}

void fill_edge_pseudonormals(Part& part, const EdgeTable& edges, const std::vector<bool>& flat) {
  // What a triangle shows to the one across edge k: its facet normal. A triangle without area is a seam: over
  // its longest edge one meets the facets behind its two short ones.
  const bool any_flat = std::find(flat.begin(), flat.end(), true) != flat.end();
  const Across across(edges, any_flat ? part.triangle_count() : 0);
  const auto shown = [&](int h) -> Vec3 {
    const int t = h / 3;
    if (!flat[at(t)]) return part.facet_normals.col(t);
    Vec3 own = part.facet_normals.col(t);
    if (shape_of(part.vertices, part.triangles, t).longest_edge != h % 3) return own;
    Vec3 sum = Vec3::Zero();
    for (const int step : {1, 2}) {
      across.visit(3 * t + (h % 3 + step) % 3, [&](int other) { sum += part.facet_normals.col(other); });
    }
    if (sum.norm() > vanishing) own = sum.normalized();
    return own;
  };
  part.edge_pseudonormals.resize(3, Eigen::Index(3) * part.triangle_count());
  prefer_large_pages(part.edge_pseudonormals);
  const bool all_on_edges = edges.half_edges.size() == at(3 * part.triangle_count());
  if (!all_on_edges) part.edge_pseudonormals.setZero();
  in_parallel(edges.edge_count(), [&](int begin, int end) {
    for (int e = begin; e < end; ++e) {
      Vec3 sum = Vec3::Zero();
      for (const int h : edges.on_edge(e)) sum += shown(h);
      const bool vanishes = sum.norm() <= vanishing;
      const Vec3 unit = sum.normalized();
      for (const int h : edges.on_edge(e)) {
        part.edge_pseudonormals.col(h) = vanishes ? Vec3(part.facet_normals.col(h / 3)) : unit;
      }
    }
  });
}

Points corner_angles(const Part& part) {
  Points angles(3, part.triangle_count());
  in_parallel(part.triangle_count(), [&](int begin, int end) {
    for (int t = begin; t < end; ++t) {
      std::array<Vec3, 3> edge;
      for (int k = 0; k < 3; ++k) {
        edge[at(k)] =
            part.vertices.col(part.triangles((k + 1) % 3, t)) - part.vertices.col(part.triangles(k, t));
      }
      // One cross product serves all three corners: each is twice the area.
      const double twice_area = edge[0].cross(edge[1]).norm();
      for (int k = 0; k < 3; ++k)
        angles(k, t) = std::atan2(twice_area, -edge[at(k)].dot(edge[at((k + 2) % 3)]));
    }
  });
  return angles;
}

CornersAtVertices corners_at_vertices(const Part& part) {
  CornersAtVertices corners;
  corners.starts.assign(at(part.welded_count) + 1, 0);
  for (const int v : part.welded.reshaped()) ++corners.starts[at(v) + 1];
  std::partial_sum(corners.starts.begin(), corners.starts.end(), corners.starts.begin());
  corners.columns.resize(at(3 * part.triangle_count()));
  std::vector<int> fill(corners.starts.begin(), corners.starts.end() - 1);
  int column = 0;
  for (const int v : part.welded.reshaped()) corners.columns[at(fill[at(v)]++)] = column++;
  return corners;
}

void fill_vertex_pseudonormals(Part& part, const CornersAtVertices& corners, const Points& angles) {
  part.vertex_pseudonormals.resize(3, part.welded_count);
  in_parallel(part.welded_count, [&](int begin, int end) {
    for (int v = begin; v < end; ++v) {
      Vec3 sum = Vec3::Zero();
      for (const int column : corners.at(v))
        sum += angles(column % 3, column / 3) * part.facet_normals.col(column / 3);
      if (sum.norm() <= vanishing && !corners.at(v).empty())
        sum = part.facet_normals.col(corners.at(v).front() / 3);
      part.vertex_pseudonormals.col(v) = sum.normalized();
    }
  });
}

void fill_creases(Part& part, double crease_rad) {
  constexpr double rounding_rad = 1e-9;  // so that an edge of just the crease angle is smooth on both sides
  constexpr double margin = 1e-6;        // where the cosine alone tells
  const double limit_rad = std::min(crease_rad, std::numbers::pi) + rounding_rad;
  const double limit_cos = std::cos(std::min(limit_rad, std::numbers::pi));
  part.creases.assign(at(part.triangle_count()), 0);
  const auto is_crease = [&](int t, int other) {
    if (other < 0) return true;
    const Vec3 a = part.facet_normals.col(t), b = part.facet_normals.col(other);
    const double cosine = a.dot(b);
    if (std::abs(cosine - limit_cos) < margin) return std::atan2(a.cross(b).norm(), cosine) > limit_rad;
    return cosine < limit_cos;
  };
  in_parallel(part.triangle_count(), [&](int begin, int end) {
    for (int t = begin; t < end; ++t) {
      for (int k = 0; k < 3; ++k) {
        if (is_crease(t, part.neighbours(k, t))) part.creases[at(t)] |= static_cast<std::uint8_t>(1u << k);
      }
    }
  });
}

}  // namespace fingerpad
