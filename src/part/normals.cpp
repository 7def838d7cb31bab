#include "part/normals.hpp"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <limits>

namespace fingerpad {
namespace {

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

/// A sum of unit normals shorter than this points nowhere: its direction is rounding.
constexpr double vanishing = 1e-12;

/// The facets across the edges of the mesh's triangles, whatever their number.
class Across {
 public:
  Across(const EdgeTable& edges, int triangle_count) : edges_(edges), edge_of_(at(3 * triangle_count), -1) {
    for (int e = 0; e < edges.edge_count(); ++e) {
      for (const int h : edges.on_edge(e)) edge_of_[at(h)] = e;
    }
  }

  /// Visits the other triangles at half-edge h.
  template <typename Visit>
  void visit(int h, Visit&& visit) const {
    if (edge_of_[at(h)] < 0) return;
    for (const int other : edges_.on_edge(edge_of_[at(h)])) {
      if (other != h) visit(other / 3);
    }
  }

 private:
  const EdgeTable& edges_;
  std::vector<int> edge_of_;
};

double area_of(const Part& part, int t) {
  return shape_of(part.vertices, part.triangles, t).area.norm();
}

/// The largest triangle with a normal across these edges of t, or -1.
int largest_across(const Part& part, const Points& normals, const Across& across, int t, bool only_longest) {
  int best = -1;
  double best_area = -1;
  const int longest = shape_of(part.vertices, part.triangles, t).longest_edge;
  for (int k = 0; k < 3; ++k) {
    if (only_longest && k != longest) continue;
    across.visit(3 * t + k, [&](int other) {
      const double area = area_of(part, other);
      if (normals.col(other).isZero(0) || area <= best_area) return;
      best = other;
      best_area = area;
    });
  }
  return best;
}

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

Points facet_normals(const Part& part, const EdgeTable& edges, const std::vector<bool>& flat) {
  Points normals = Points::Zero(3, part.triangle_count());
  std::vector<int> waiting;
  for (int t = 0; t < part.triangle_count(); ++t) {
    if (flat[at(t)]) {
      waiting.push_back(t);
    } else {
      normals.col(t) = shape_of(part.vertices, part.triangles, t).area.normalized();
    }
  }
  if (waiting.empty()) return normals;
  const Across across(edges, part.triangle_count());
  // First across longest edges as far as that reaches, then one step across any edge, and again.
  bool only_longest = true;
  constexpr int many_rounds = 200;  // a strip of seams is done in a few, as every round turns back
  for (int round = 0; round < many_rounds && !waiting.empty(); ++round) {
    std::vector<int> still;
    for (const int t : waiting) {
      const int giver = largest_across(part, normals, across, t, only_longest);
      if (giver < 0) {
        still.push_back(t);
      } else {
        normals.col(t) = normals.col(giver);
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
  const Across across(edges, part.triangle_count());
  const auto shown = [&](int h) -> Vec3 {
    const int t = h / 3;
    const Vec3 own = part.facet_normals.col(t);
    if (!flat[at(t)] || shape_of(part.vertices, part.triangles, t).longest_edge != h % 3) return own;
    Vec3 sum = Vec3::Zero();
    for (const int step : {1, 2}) {
      across.visit(3 * t + (h % 3 + step) % 3, [&](int other) { sum += part.facet_normals.col(other); });
    }
    return sum.norm() > vanishing ? Vec3(sum.normalized()) : own;
  };
  part.edge_pseudonormals = Points::Zero(3, 3 * part.triangle_count());
  for (int e = 0; e < edges.edge_count(); ++e) {
    Vec3 sum = Vec3::Zero();
    for (const int h : edges.on_edge(e)) sum += shown(h);
    const bool vanishes = sum.norm() <= vanishing;
    const Vec3 unit = sum.normalized();
    for (const int h : edges.on_edge(e)) {
      part.edge_pseudonormals.col(h) = vanishes ? Vec3(part.facet_normals.col(h / 3)) : unit;
    }
  }
}

double corner_angle(const Part& part, int t, int k) {
  const Vec3 corner = part.vertices.col(part.triangles(k, t));
  const Vec3 to_next = part.vertices.col(part.triangles((k + 1) % 3, t)) - corner;
  const Vec3 to_last = part.vertices.col(part.triangles((k + 2) % 3, t)) - corner;
  return std::atan2(to_next.cross(to_last).norm(), to_next.dot(to_last));
}

void fill_vertex_pseudonormals(Part& part) {
  part.vertex_pseudonormals = Points::Zero(3, part.welded_count);
  for (int t = 0; t < part.triangle_count(); ++t) {
    for (int k = 0; k < 3; ++k) {
      part.vertex_pseudonormals.col(part.welded(k, t)) +=
          corner_angle(part, t, k) * part.facet_normals.col(t);
    }
  }
  for (int t = part.triangle_count() - 1; t >= 0; --t) {
    // Downwards, so that of the triangles at a vanishing sum the lowest is written last.
    for (int k = 0; k < 3; ++k) {
      auto normal = part.vertex_pseudonormals.col(part.welded(k, t));
      const double length = normal.norm();
      if (length <= vanishing) normal = 0.5 * vanishing * part.facet_normals.col(t);
    }
  }
  part.vertex_pseudonormals.colwise().normalize();
}

void fill_creases(Part& part, double crease_rad) {
  constexpr double rounding_rad = 1e-9;  // so that an edge of just the crease angle is smooth on both sides
  part.creases.assign(at(part.triangle_count()), 0);
  for (int t = 0; t < part.triangle_count(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const int other = part.neighbours(k, t);
      bool crease = other < 0;
      if (!crease) {
        const Vec3 a = part.facet_normals.col(t), b = part.facet_normals.col(other);
        crease = std::atan2(a.cross(b).norm(), a.dot(b)) > crease_rad + rounding_rad;
      }
      if (crease) part.creases[at(t)] |= static_cast<std::uint8_t>(1u << k);
    }
  }
}

}  // namespace fingerpad
