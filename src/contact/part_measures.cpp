#include "contact/part_measures.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>
#include <vector>

#include "contact/edge_measures.hpp"
#include "contact/ray_budget.hpp"
#include "contact/surface_places.hpp"
#include "contact/triangle_tree.hpp"

namespace fingerpad {
namespace {

/// Of a mesh with more facets than `most_rays` only every k-th sends a ray.
constexpr int most_rays = 60000, most_starts = 40000, most_overlap_rays = 10000;
constexpr int most_cuts = 8;
constexpr double cos_facing = 0.86602540378443865;  // 30 degrees

Vec3 corner(const Part& part, int t, int k) {
  return part.vertices.col(part.triangles(k % 3, t));
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

/// The radius that so large a share of the places is not rounded tighter than.
double round_radius_m(const std::vector<SurfacePlace>& places, double share) {
  if (places.empty()) return PartMeasures::inf;
  std::vector<double> curvatures_per_m;
  curvatures_per_m.reserve(places.size());
  for (const SurfacePlace& place : places) curvatures_per_m.push_back(place.curvature_per_m);
  const auto at =
      curvatures_per_m.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(places.size() - 1));
  std::nth_element(curvatures_per_m.begin(), at, curvatures_per_m.end());
  return *at > 0 ? 1 / *at : PartMeasures::inf;
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
  if (part.triangle_count() == 0) return {};
  const double trusted_height_m = trusted_height_of(part);
  PartMeasures measures = measured_edges(part, trusted_height_m);
  WallSamples samples(part, tree, trusted_height_m);
  samples.take();
  measures.overlap_count = samples.overlap_count();
  measures.ray_count = static_cast<int>(samples.walls().size());
  measures.median_m = median_thickness(samples.walls());
  measures.thinnest_m = samples.walls().front().thickness_m;
  if (is_far_off(part)) measures.rounding_m = rounding_of(part);
  measures.places = surface_places(tree, trusted_height_m);
  measures.untold_share = untold_share(measures.places);
  measures.tightest_round_m = round_radius_m(measures.places, 0.99);
  measures.median_round_m = round_radius_m(measures.places, 0.5);
  for (const Wall& wall : samples.walls())
    measures.thinnest_wall_m = std::min(measures.thinnest_wall_m, wall.through_m);
  return measures;
}

double told_wall_m(const Part& part, const PartMeasures& measures) noexcept {
  const bool has_inside = part.triangle_count() > 0 && measures.open_edges == 0;
  return has_inside ? measures.thinnest_wall_m : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace fingerpad
