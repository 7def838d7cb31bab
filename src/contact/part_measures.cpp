#include "contact/part_measures.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace fingerpad {
namespace {

constexpr int most_rays = 60000;
constexpr int most_cuts = 8;
/// Half a unit in the last place of a float32 number, relative to it.
constexpr double float32_rounding = 6e-8;
constexpr double trusted_roundings = 100;
/// Nearer than this, unit normals are those of one plane: a square of the turn.
constexpr double flat_turn2 = 1e-12;
/// A hollow is only measured across edges that turn by more: less is one plane's rounding.
constexpr double hollow_turn_rad = 0.0175;

Vec3 corner(const Part& part, int t, int k) {
  return part.vertices.col(part.triangles(k % 3, t));
}

/// An edge between two triangles: edge k of t, and the corner of the other triangle beyond it.
struct Fold {
  double turn_rad = 0;
  bool is_concave = false, contradicts = false;
  double height_m = 0;  ///< of the lower of both triangles over the edge
};

/// Which corner of triangle `other` is not on edge k of triangle t.
int corner_beyond(const Part& part, int t, int k, int other) {
  const int a = part.welded(k, t), b = part.welded((k + 1) % 3, t);
  int j = 0;
  while (j < 2 && (part.welded(j, other) == a || part.welded(j, other) == b)) ++j;
  return j;
}

Fold fold_at(const Part& part, int t, int k) {
  const int other = part.neighbours(k, t);
  const int beyond = corner_beyond(part, t, k, other);
  Fold fold;
  // Neighbours wound alike pass their common edge in opposite directions.
  fold.contradicts = part.welded((beyond + 1) % 3, other) == part.welded(k, t);
  const Vec3 n = part.facet_normals.col(t), m = part.facet_normals.col(other);
  if ((n - m).squaredNorm() <= flat_turn2) return fold;
  const Vec3 a = corner(part, t, k), edge = corner(part, t, k + 1) - a;
  const Vec3 here = corner(part, t, k + 2) - a, there = corner(part, other, beyond) - a;
  const double length_m = edge.norm();
  if (!(length_m > 0)) return fold;
  fold.height_m = std::min(here.cross(edge).norm(), there.cross(edge).norm()) / length_m;
  fold.turn_rad = std::atan2(n.cross(m).norm(), n.dot(m));
  fold.is_concave = n.dot(there) > 0;
  return fold;
}

void take_fold(PartMeasures& sum, const Fold& fold, bool is_crease) {
  if (!fold.is_concave) sum.sharpest_ridge_rad = std::max(sum.sharpest_ridge_rad, fold.turn_rad);
  if (is_crease) {
    if (fold.is_concave) sum.sharpest_valley_rad = std::max(sum.sharpest_valley_rad, fold.turn_rad);
    return;
  }
  sum.largest_smooth_turn_rad = std::max(sum.largest_smooth_turn_rad, fold.turn_rad);
  // Chord h under an arc that turns by phi: radius h/(2 sin(phi/2)), sagitta h phi/8 (to third order).
  sum.largest_sag_m = std::max(sum.largest_sag_m, fold.height_m * fold.turn_rad / 8);
  if (fold.is_concave && fold.turn_rad > hollow_turn_rad) {
    sum.tightest_hollow_m =
        std::min(sum.tightest_hollow_m, fold.height_m / (2 * std::sin(fold.turn_rad / 2)));
  }
}

void look_at_edges(const Part& part, int t, double trusted_height_m, PartMeasures& sum) {
  sum.volume_m3 += corner(part, t, 0).dot(corner(part, t, 1).cross(corner(part, t, 2))) / 6;
  for (int k = 0; k < 3; ++k) {
    const int other = part.neighbours(k, t);
    if (other < 0) {
      ++sum.open_edges;
      continue;
    }
    if (other < t) continue;  // seen from there
    const Fold fold = fold_at(part, t, k);
    sum.contradicting_edges += fold.contradicts ? 2 : 0;
    if (fold.contradicts || !(fold.height_m > trusted_height_m)) continue;
    take_fold(sum, fold, (part.creases[static_cast<std::size_t>(t)] >> k & 1) != 0);
  }
}

PartMeasures joined(PartMeasures a, const PartMeasures& b) {
  a.open_edges += b.open_edges;
  a.contradicting_edges += b.contradicting_edges;
  a.volume_m3 += b.volume_m3;
  a.sharpest_ridge_rad = std::max(a.sharpest_ridge_rad, b.sharpest_ridge_rad);
  a.sharpest_valley_rad = std::max(a.sharpest_valley_rad, b.sharpest_valley_rad);
  a.tightest_hollow_m = std::min(a.tightest_hollow_m, b.tightest_hollow_m);
  a.largest_smooth_turn_rad = std::max(a.largest_smooth_turn_rad, b.largest_smooth_turn_rad);
  a.largest_sag_m = std::max(a.largest_sag_m, b.largest_sag_m);
  return a;
}

PartMeasures measured_edges(const Part& part) {
  const double largest_m = part.half_extent.maxCoeff() + part.centre_P.cwiseAbs().maxCoeff();
  const double trusted_height_m = trusted_roundings * float32_rounding * largest_m;
  // Deterministic: the volume is a sum, and sums depend on their order.
  return tbb::parallel_deterministic_reduce(
      tbb::blocked_range<int>(0, part.triangle_count(), 4096), PartMeasures(),
      [&](const tbb::blocked_range<int>& range, PartMeasures sum) {
        for (int t = range.begin(); t != range.end(); ++t) look_at_edges(part, t, trusted_height_m, sum);
        return sum;
      },
      joined);
}

/// Local thickness under one point of facet t, and the area that the point stands for.
struct Wall {
  double thickness_m = PartMeasures::inf;
  double area_m2 = 0;
};

double thickness_at(const Part& part, const TriangleTree& tree, int t, const Vec3& barycentric) {
  Vec3 point = Vec3::Zero();
  for (int k = 0; k < 3; ++k) point += barycentric[k] * part.vertices.col(part.triangles(k, t));
  const Vec3 normal = part.facet_normals.col(t);
  const RayExit exit = tree.first_exit(t, point, -normal);
  if (exit.triangle < 0) return PartMeasures::inf;
  const double cosine =
      -part.facet_normals.col(exit.triangle).dot(normal);  // of the angle between the facets
  if (cosine < -std::cos(opposite_turn_rad)) return PartMeasures::inf;
  const double tan2_half = (1 - std::min(1.0, cosine)) / (1 + cosine);
  return exit.distance_m * (1 - tan2_half);
}

/// The walls under the centres of the m x m like parts of facet t, m * m of them.
void measure_facet(const Part& part, const TriangleTree& tree, int t, int m, Wall* walls) {
  const Vec3 a = corner(part, t, 0);
  const double area_m2 = (corner(part, t, 1) - a).cross(corner(part, t, 2) - a).norm() / (2.0 * m * m);
  const auto take = [&](double u, double v) {
    *walls++ = {thickness_at(part, tree, t, {1 - u - v, u, v}), area_m2};
  };
  for (int i = 0; i < m; ++i) {
    for (int j = 0; i + j < m; ++j) {
      const double u = (i + 1.0 / 3) / m, v = (j + 1.0 / 3) / m, step = 1.0 / (3.0 * m);
      take(u, v);
      if (i + j + 1 < m) take(u + step, v + step);  // the part that stands on its head
    }
  }
}

double median_thickness(std::vector<Wall>& walls) {
  std::sort(walls.begin(), walls.end(),
            [](const Wall& a, const Wall& b) { return a.thickness_m < b.thickness_m; });
  const auto add = [](double sum, const Wall& wall) { return sum + wall.area_m2; };
  const double half = std::accumulate(walls.begin(), walls.end(), 0.0, add) / 2;
  double sum = 0;
  for (const Wall& wall : walls) {
    sum += wall.area_m2;
    if (sum >= half) return wall.thickness_m;
  }
  return PartMeasures::inf;
}

}  // namespace

PartMeasures measure_part(const Part& part, const TriangleTree& tree) {
  const int count = part.triangle_count();
  if (count == 0) return {};
  PartMeasures measures = measured_edges(part);
  int m = 1;
  while (m < most_cuts && static_cast<long>(m + 1) * (m + 1) * count <= most_rays) ++m;
  const int stride = (count + most_rays - 1) / most_rays;
  const int starts = (count + stride - 1) / stride;
  const auto rays_each = static_cast<std::size_t>(m) * static_cast<std::size_t>(m);
  std::vector<Wall> walls(static_cast<std::size_t>(starts) * rays_each);
  tbb::parallel_for(tbb::blocked_range<int>(0, starts, 64), [&](const tbb::blocked_range<int>& range) {
    for (int i = range.begin(); i != range.end(); ++i)
      measure_facet(part, tree, i * stride, m, &walls[static_cast<std::size_t>(i) * rays_each]);
  });
  measures.ray_count = static_cast<int>(walls.size());
  measures.median_m = median_thickness(walls);
  measures.thinnest_m = walls.front().thickness_m;
  return measures;
}

}  // namespace fingerpad
