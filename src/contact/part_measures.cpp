#include "contact/part_measures.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "contact/ray_budget.hpp"
#include "contact/triangle_tree.hpp"

namespace fingerpad {
namespace {

/// Of a mesh with more facets than `most_rays` only every k-th sends a ray.
constexpr int most_rays = 60000, most_starts = 40000, most_overlap_rays = 10000;
constexpr int most_cuts = 8;
constexpr double cos_facing = 0.86602540378443865;  // 30 degrees
/// Half a unit in the last place of a float32 number, relative to it.
constexpr double float32_rounding = 6e-8;
constexpr double trusted_roundings = 100;
/// Nearer than this, unit normals are those of one plane: a square of the turn.
constexpr double flat_turn2 = 1e-12;
/// A hollow is only measured across edges that turn by more, a degree: less is one plane's rounding.
constexpr double hollow_chord = 0.0175;

Vec3 corner(const Part& part, int t, int k) {
  return part.vertices.col(part.triangles(k % 3, t));
}

/// An edge between two triangles: edge k of t, and the corner of the other triangle beyond it.
struct Fold {
  double chord = 0;  ///< between the tips of both unit normals: 2 sin(turn / 2)
  bool is_concave = false, contradicts = false;
  double height_m = 0;  ///< of the lower of both triangles over the edge
};

double turn_of(double chord) {
  return 2 * std::asin(std::min(chord / 2, 1.0));
}

/// What all edges say: the measures, and the largest chords in place of turns.
struct Edges {
  PartMeasures sum;
  double ridge_chord = 0, valley_chord = 0, smooth_chord = 0;
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
  const double chord2 = (n - m).squaredNorm();
  if (chord2 <= flat_turn2) return fold;
  const Vec3 a = corner(part, t, k), edge = corner(part, t, k + 1) - a;
  const Vec3 here = corner(part, t, k + 2) - a, there = corner(part, other, beyond) - a;
  const double length2_m2 = edge.squaredNorm();
  if (!(length2_m2 > 0)) return fold;
  const double area2_m4 = std::min(here.cross(edge).squaredNorm(), there.cross(edge).squaredNorm());
  fold.height_m = std::sqrt(area2_m4 / length2_m2);
  fold.chord = std::sqrt(chord2);
  fold.is_concave = n.dot(there) > 0;
  return fold;
}

void take_fold(Edges& edges, const Fold& fold, bool is_crease) {
  if (!fold.is_concave) edges.ridge_chord = std::max(edges.ridge_chord, fold.chord);
  if (is_crease) {
    if (fold.is_concave) edges.valley_chord = std::max(edges.valley_chord, fold.chord);
    return;
  }
  PartMeasures& sum = edges.sum;
  edges.smooth_chord = std::max(edges.smooth_chord, fold.chord);
  // Chord h under an arc that turns by phi: radius h/(2 sin(phi/2)), sagitta h phi/8 (to third order). phi is
  // at most pi/2 times its own chord, and asked for only where that could make the sagitta the largest.
  if (fold.height_m * fold.chord * (std::numbers::pi / 16) > sum.largest_sag_m)
    sum.largest_sag_m = std::max(sum.largest_sag_m, fold.height_m * turn_of(fold.chord) / 8);
  if (fold.is_concave && fold.chord > hollow_chord)
    sum.tightest_hollow_m = std::min(sum.tightest_hollow_m, fold.height_m / fold.chord);
}

void look_at_edges(const Part& part, int t, double trusted_height_m, Edges& edges) {
  PartMeasures& sum = edges.sum;
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
    take_fold(edges, fold, (part.creases[static_cast<std::size_t>(t)] >> k & 1) != 0);
  }
}

Edges joined(Edges a, const Edges& b) {
  a.sum.open_edges += b.sum.open_edges;
  a.sum.contradicting_edges += b.sum.contradicting_edges;
  a.sum.volume_m3 += b.sum.volume_m3;
  a.sum.tightest_hollow_m = std::min(a.sum.tightest_hollow_m, b.sum.tightest_hollow_m);
  a.sum.largest_sag_m = std::max(a.sum.largest_sag_m, b.sum.largest_sag_m);
  a.ridge_chord = std::max(a.ridge_chord, b.ridge_chord);
  a.valley_chord = std::max(a.valley_chord, b.valley_chord);
  a.smooth_chord = std::max(a.smooth_chord, b.smooth_chord);
  return a;
}

/// The height from which a facet's normal is believed.
double trusted_height_of(const Part& part) {
  const double largest_m = part.half_extent.maxCoeff() + part.centre_P.cwiseAbs().maxCoeff();
  return trusted_roundings * float32_rounding * largest_m;
}

PartMeasures measured_edges(const Part& part, double trusted_height_m) {
  // Deterministic: the volume is a sum, and sums depend on their order.
  Edges edges = tbb::parallel_deterministic_reduce(
      tbb::blocked_range<int>(0, part.triangle_count(), 4096), Edges(),
      [&](const tbb::blocked_range<int>& range, Edges some) {
        for (int t = range.begin(); t != range.end(); ++t) look_at_edges(part, t, trusted_height_m, some);
        return some;
      },
      joined);
  edges.sum.sharpest_ridge_rad = turn_of(edges.ridge_chord);
  edges.sum.sharpest_valley_rad = turn_of(edges.valley_chord);
  edges.sum.largest_smooth_turn_rad = turn_of(edges.smooth_chord);
  return edges.sum;
}

/// What is under one point of facet t, and the area that the point stands for.
struct Wall {
  double thickness_m = PartMeasures::inf;  ///< local thickness
  double through_m = PartMeasures::inf;    ///< to a side that faces this one
  double area_m2 = 0;
};

/// A ray from a place on facet t straight inwards, and where it leaves.
struct Probe {
  int facet;
  Vec3 from, inwards;
  RayExit exit;
};

Probe probe_at(const Part& part, const TriangleTree& tree, int t, const Vec3& barycentric) {
  Probe probe{t, Vec3::Zero(), -part.facet_normals.col(t), {}};
  for (int k = 0; k < 3; ++k) probe.from += barycentric[k] * part.vertices.col(part.triangles(k, t));
  probe.exit = tree.first_exit(t, probe.from, probe.inwards);
  return probe;
}

/// Whether another sheet is entered before the probe leaves, or within `slack_m` behind.
bool meets_overlap(const TriangleTree& tree, const Probe& probe, double slack_m) {
  if (probe.exit.triangle < 0) return false;
  const auto at = [&](double distance_m) -> Vec3 { return probe.from + distance_m * probe.inwards; };
  const SegmentHit entry = tree.first_crossing(at(slack_m), at(probe.exit.distance_m + slack_m));
  if (entry.triangle < 0) return false;
  // first_exit passes over the facets around its own: it may have left through one of these before.
  const double entered_m = slack_m + entry.along * probe.exit.distance_m;
  return tree.first_crossing(at(entered_m - slack_m), at(slack_m)).triangle < 0;
}

Wall wall_of(const Part& part, const Probe& probe, double area_m2) {
  Wall wall;
  wall.area_m2 = area_m2;
  const RayExit& exit = probe.exit;
  if (exit.triangle < 0) return wall;
  const double cosine =
      part.facet_normals.col(exit.triangle).dot(probe.inwards);  // of the angle between the facets
  if (cosine >= cos_facing) wall.through_m = exit.distance_m;
  if (cosine < -std::cos(opposite_turn_rad)) return wall;
  const double tan2_half = (1 - std::min(1.0, cosine)) / (1 + cosine);
  wall.thickness_m = exit.distance_m * (1 - tan2_half);
  return wall;
}

/// What the rays from under a part's facets meet.
class WallSamples {
 public:
  /// @param trusted_height_m  of facets whose normals are believed
  WallSamples(const Part& part, const TriangleTree& tree, double trusted_height_m)
      : part_(part), tree_(tree), trusted_height_m_(trusted_height_m) {
    const int count = part.triangle_count();
    const int affordable = affordable_rays(part), rays = std::min(most_rays, affordable),
              most = std::min(most_starts, affordable);
    while (m_ < most_cuts && static_cast<long>(m_ + 1) * (m_ + 1) * count <= rays) ++m_;
    stride_ = count > rays ? (count + most - 1) / most : 1;
    starts_ = (count + stride_ - 1) / stride_;
    walls_.resize(static_cast<std::size_t>(starts_) * static_cast<std::size_t>(m_ * m_));
    overlap_stride_ = (static_cast<int>(walls_.size()) + most_overlap_rays - 1) / most_overlap_rays;
  }

  void take() {
    tbb::parallel_for(tbb::blocked_range<int>(0, starts_, 64), [&](const tbb::blocked_range<int>& range) {
      for (int i = range.begin(); i != range.end(); ++i) take_facet(i);
    });
  }

  std::vector<Wall>& walls() { return walls_; }
  int overlap_count() const { return overlap_count_; }

 private:
  /// Under the centres of the m x m like parts of a facet.
  void take_facet(int i) {
    const int t = i * stride_;
    const Vec3 a = corner(part_, t, 0), ab = corner(part_, t, 1) - a, ac = corner(part_, t, 2) - a;
    const double area_m2 = ab.cross(ac).norm() / 2;
    const double longest_m =
        std::sqrt(std::max({ab.squaredNorm(), ac.squaredNorm(), (ac - ab).squaredNorm()}));
    const bool is_believed = 2 * area_m2 > trusted_height_m_ * longest_m;
    const bool look_for_overlap = is_believed && i % overlap_stride_ == 0;
    Wall* walls = &walls_[static_cast<std::size_t>(i) * static_cast<std::size_t>(m_ * m_)];
    const auto take = [&](double u, double v) {
      const Probe probe = probe_at(part_, tree_, t, {1 - u - v, u, v});
      *walls++ = wall_of(part_, probe, area_m2 / (m_ * m_));
      if (look_for_overlap && meets_overlap(tree_, probe, trusted_height_m_)) ++overlap_count_;
    };
    for (int row = 0; row < m_; ++row) {
      for (int j = 0; row + j < m_; ++j) {
        const double u = (row + 1.0 / 3) / m_, v = (j + 1.0 / 3) / m_, step = 1.0 / (3.0 * m_);
        take(u, v);
        if (row + j + 1 < m_) take(u + step, v + step);  // the part that stands on its head
      }
    }
  }

  const Part& part_;
  const TriangleTree& tree_;
  double trusted_height_m_;
  int m_ = 1, stride_ = 1, starts_ = 0, overlap_stride_ = 1;
  std::vector<Wall> walls_;
  std::atomic<int> overlap_count_{0};
};

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
  if (part.triangle_count() == 0) return {};
  const double trusted_height_m = trusted_height_of(part);
  PartMeasures measures = measured_edges(part, trusted_height_m);
  WallSamples samples(part, tree, trusted_height_m);
  samples.take();
  measures.overlap_count = samples.overlap_count();
  measures.ray_count = static_cast<int>(samples.walls().size());
  measures.median_m = median_thickness(samples.walls());
  measures.thinnest_m = samples.walls().front().thickness_m;
  for (const Wall& wall : samples.walls())
    measures.thinnest_wall_m = std::min(measures.thinnest_wall_m, wall.through_m);
  return measures;
}

double told_wall_m(const Part& part, const PartMeasures& measures) noexcept {
  const bool has_inside = part.triangle_count() > 0 && measures.open_edges == 0;
  return has_inside ? measures.thinnest_wall_m : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace fingerpad
