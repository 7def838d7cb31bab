#include "contact/curved_normals.hpp"

#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace fingerpad {
namespace {

constexpr int most_triangles = 64;

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

/// The facet's normal times its angle at the corner times its area, up to a factor common to all.
Vec3 weighted_normal(const Part& part, int t, int corner) noexcept {
  const Vec3 p = part.vertices.col(part.triangles(corner, t));
  const Vec3 a = part.vertices.col(part.triangles((corner + 1) % 3, t)) - p;
  const Vec3 b = part.vertices.col(part.triangles((corner + 2) % 3, t)) - p;
  const double doubled_area = a.cross(b).norm();
  if (!(doubled_area > 0)) return Vec3::Zero();
  const double half_angle =
      rough_angle(doubled_area, std::sqrt(a.squaredNorm() * b.squaredNorm()) + a.dot(b));
  return half_angle * doubled_area * part.facet_normals.col(t);
}

}  // namespace

Vec3 curved_corner_normal(const Part& part, int t, int corner) noexcept {
  Vec3 otherwise = part.corner_normals.col(Eigen::Index{3} * t + corner);
  Vec3 sum = weighted_normal(part, t, corner);
  int count = 1;
  for (const int edge : {corner, (corner + 2) % 3}) {
    Step step = crossed(part, {t, corner, edge});
    while (step.triangle >= 0 && step.triangle != t) {
      if (++count > most_triangles) return otherwise;
      sum += weighted_normal(part, step.triangle, step.corner);
      step = crossed(part, step);
    }
    if (step.triangle == t) break;
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
