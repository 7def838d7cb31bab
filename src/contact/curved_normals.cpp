#include "contact/curved_normals.hpp"

#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>

namespace fingerpad {
namespace {

constexpr std::size_t most_triangles = 64;
/// Of the area of the largest facet that is half of a flat polygon: a facet with less does not count beside
/// it, as one of a fillet beside a wall; from so much on it counts.
constexpr double narrow = 0.25, wide = 0.5;
/// Facets whose normals differ by less are of one plane, by more of two [rad]: float32 files tell them to
/// some 1e-5.
constexpr double one_plane_rad = 1e-4, two_planes_rad = 1e-3;

/// A corner on the way around a vertex, and the edge at which its triangle will be left.
struct Step {
  int triangle, corner, edge;
};

/// The next corner around, -1 behind a crease.
Step crossed(const Part& part, const Step& at) noexcept {
  const int other = part.neighbours(at.edge, at.triangle);
  if (other < 0 || (part.creases[static_cast<std::size_t>(at.triangle)] >> at.edge & 1) != 0)
    return {-1, 0, 0};
  const int vertex = part.welded(at.corner, at.triangle);
  const int far_vertex = part.welded(at.edge == at.corner ? (at.corner + 1) % 3 : at.edge, at.triangle);
  int corner = 0;
  while (corner < 3 && part.welded(corner, other) != vertex) ++corner;
  if (corner == 3) return {-1, 0, 0};
  const bool came_by_own_edge = part.welded((corner + 1) % 3, other) == far_vertex;
  return {other, corner, came_by_own_edge ? (corner + 2) % 3 : corner};
}

/// atan(y/x) for x, y >= 0, to 1e-5 (Abramowitz & Stegun 4.4.49): the same on every machine, and quick.
double rough_angle(double y, double x) noexcept {
  const double ratio = y <= x ? y / x : x / y, s = ratio * ratio;
  const double angle =
      ratio * (0.9998660 + s * (-0.3302995 + s * (0.1801410 + s * (-0.0851330 + s * 0.0208351))));
  return y <= x ? angle : std::numbers::pi / 2 - angle;
}

double risen(double from, double to, double x) noexcept {
  const double s = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return s * s * (3 - 2 * s);
}

/// 1 where a neighbour lies in the facet's plane, as the other half of a quad does, 0 where none does.
double shares_plane(const Part& part, int t) noexcept {
  double nearest_rad = two_planes_rad;
  for (int k = 0; k < 3; ++k) {
    const int other = part.neighbours(k, t);
    if (other < 0) continue;
    nearest_rad = std::min(nearest_rad, (part.facet_normals.col(t) - part.facet_normals.col(other)).norm());
  }
  return risen(two_planes_rad, one_plane_rad, nearest_rad);
}

/// A facet at a vertex: its angle there and its area, each up to a factor common to all, and the area that
/// others are held against.
struct FanFacet {
  Vec3 normal;
  double angle = 0, area = 0, area_of_face = 0;
};

FanFacet fan_facet(const Part& part, int t, int corner) noexcept {
  const Vec3 p = part.vertices.col(part.triangles(corner, t));
  const Vec3 a = part.vertices.col(part.triangles((corner + 1) % 3, t)) - p;
  const Vec3 b = part.vertices.col(part.triangles((corner + 2) % 3, t)) - p;
  const double doubled_area = a.cross(b).norm();
  if (!(doubled_area > 0)) return {Vec3::Zero()};
  const double half_angle =
      rough_angle(doubled_area, std::sqrt(a.squaredNorm() * b.squaredNorm()) + a.dot(b));
  return {part.facet_normals.col(t), half_angle, doubled_area, doubled_area * shares_plane(part, t)};
}

/// The smooth fan around a corner.
struct Fan {
  std::array<FanFacet, most_triangles> facets;
  std::size_t count = 0;

  std::span<const FanFacet> all() const noexcept { return std::span(facets).first(count); }
};

/// False where it has too many.
bool gather(const Part& part, int t, int corner, Fan& fan) noexcept {
  fan.facets[fan.count++] = fan_facet(part, t, corner);
  for (const int edge : {corner, (corner + 2) % 3}) {
    Step step = crossed(part, {t, corner, edge});
    while (step.triangle >= 0 && step.triangle != t) {
      if (fan.count == fan.facets.size()) return false;
      fan.facets[fan.count++] = fan_facet(part, step.triangle, step.corner);
      step = crossed(part, step);
    }
    if (step.triangle == t) break;
  }
  return true;
}

}  // namespace

Vec3 curved_corner_normal(const Part& part, int t, int corner) noexcept {
  Vec3 otherwise = part.corner_normals.col(Eigen::Index{3} * t + corner);
  Fan fan;
  if (!gather(part, t, corner, fan)) return otherwise;
  double face = 0;
  for (const FanFacet& facet : fan.all()) face = std::max(face, facet.area_of_face);
  Vec3 sum = Vec3::Zero();
  for (const FanFacet& facet : fan.all()) {
    const double counts = face > 0 ? risen(narrow, wide, facet.area / face) : 1;
    sum += counts * facet.angle * facet.area * facet.normal;
  }
  const double length = sum.norm();
  Vec3 normal = sum / length;
  // A fan folded upon itself sums to nothing.
  return length > 0 && normal.dot(otherwise) > 0.5 ? normal : otherwise;
}

Points curved_corner_normals(const Part& part) {
  const int n = part.triangle_count();
  Points normals(3, Eigen::Index{3} * n);
  tbb::parallel_for(0, n, [&](int t) {
    for (int k = 0; k < 3; ++k) normals.col(Eigen::Index{3} * t + k) = curved_corner_normal(part, t, k);
  });
  return normals;
}

}  // namespace fingerpad
