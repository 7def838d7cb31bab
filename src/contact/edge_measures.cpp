#include "contact/edge_measures.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "contact/facet_rule.hpp"
#include "part/part.hpp"

namespace fingerpad {
namespace {

/// Half a unit in the last place of a float32 number, relative to it.
constexpr double float32_rounding = 6e-8;
constexpr double trusted_roundings = 100;
/// Nearer than this, unit normals are those of one plane: a square of the turn.
constexpr double flat_turn2 = 1e-12;
/// A hollow is only measured across edges that turn by more, a degree: less is one plane's rounding.
constexpr double hollow_chord = 0.0175;

Vec3 corner_at(const Part& part, int t, int k) {
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
  double ridge_chord = 0, edge_chord = 0, valley_chord = 0, smooth_chord = 0;
};

Fold fold_at(const Part& part, int t, int k) {
  const int other = part.neighbours(k, t);
  const int beyond = corner_beyond(part, t, k, other);
  Fold fold;
  // Neighbours wound alike pass their common edge in opposite directions.
  fold.contradicts = part.welded((beyond + 1) % 3, other) == part.welded(k, t);
  const Vec3 n = part.facet_normals.col(t), m = part.facet_normals.col(other);
  const double chord2 = (n - m).squaredNorm();
  if (chord2 <= flat_turn2) return fold;
  const Vec3 a = corner_at(part, t, k), edge = corner_at(part, t, k + 1) - a;
  const Vec3 here = corner_at(part, t, k + 2) - a, there = corner_at(part, other, beyond) - a;
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
    double& sharpest = fold.is_concave ? edges.valley_chord : edges.edge_chord;
    sharpest = std::max(sharpest, fold.chord);
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
  sum.volume_m3 += corner_at(part, t, 0).dot(corner_at(part, t, 1).cross(corner_at(part, t, 2))) / 6;
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
    take_fold(edges, fold, has_crease(part, t, k));
  }
}

Edges joined(Edges a, const Edges& b) {
  a.sum.open_edges += b.sum.open_edges;
  a.sum.contradicting_edges += b.sum.contradicting_edges;
  a.sum.volume_m3 += b.sum.volume_m3;
  a.sum.tightest_hollow_m = std::min(a.sum.tightest_hollow_m, b.sum.tightest_hollow_m);
  a.sum.largest_sag_m = std::max(a.sum.largest_sag_m, b.sum.largest_sag_m);
  a.ridge_chord = std::max(a.ridge_chord, b.ridge_chord);
  a.edge_chord = std::max(a.edge_chord, b.edge_chord);
  a.valley_chord = std::max(a.valley_chord, b.valley_chord);
  a.smooth_chord = std::max(a.smooth_chord, b.smooth_chord);
  return a;
}

}  // namespace

double rounding_of(const Part& part) {
  return float32_rounding * (part.half_extent.maxCoeff() + part.centre_P.cwiseAbs().maxCoeff());
}

bool is_far_off(const Part& part) {
  constexpr double far = 10;
  return part.centre_P.cwiseAbs().maxCoeff() > far * part.half_extent.maxCoeff();
}

double trusted_height_of(const Part& part) {
  return trusted_roundings * rounding_of(part);
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
  edges.sum.sharpest_edge_rad = turn_of(edges.edge_chord);
  edges.sum.sharpest_valley_rad = turn_of(edges.valley_chord);
  edges.sum.largest_smooth_turn_rad = turn_of(edges.smooth_chord);
  return edges.sum;
}

}  // namespace fingerpad
