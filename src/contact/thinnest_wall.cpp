#include "contact/thinnest_wall.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <limits>

#include "contact/ray_budget.hpp"

namespace fingerpad {
namespace {

constexpr int most_rays = 200000;
constexpr int most_cuts = 8;
constexpr double cos_facing = 0.86602540378443865;  // 30 degrees

/// The wall under one point of facet t, infinite where none is met.
double wall_at(const Part& part, const TriangleTree& tree, int t, const Vec3& barycentric) {
  Vec3 point = Vec3::Zero();
  for (int k = 0; k < 3; ++k) point += barycentric[k] * part.vertices.col(part.triangles(k, t));
  const Vec3 normal = part.facet_normals.col(t);
  const RayExit exit = tree.first_exit(t, point, -normal);
  const bool faces = exit.triangle >= 0 && part.facet_normals.col(exit.triangle).dot(normal) <= -cos_facing;
  return faces ? exit.distance_m : std::numeric_limits<double>::infinity();
}

/// The thinnest wall under the centres of the m x m like parts of facet t.
double wall_under(const Part& part, const TriangleTree& tree, int t, int m) {
  double thinnest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < m; ++i) {
    for (int j = 0; i + j < m; ++j) {
      const double u = (i + 1.0 / 3) / m, v = (j + 1.0 / 3) / m;
      thinnest = std::min(thinnest, wall_at(part, tree, t, {1 - u - v, u, v}));
      if (i + j + 1 < m) {  // the part that stands on its head
        const double step = 1.0 / (3.0 * m);
        thinnest = std::min(thinnest, wall_at(part, tree, t, {1 - u - v - 2 * step, u + step, v + step}));
      }
    }
  }
  return thinnest;
}

}  // namespace

double thinnest_wall_m(const Part& part, const TriangleTree& tree) {
  if (part.triangle_count() == 0 || part.neighbours.minCoeff() < 0) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const int count = part.triangle_count();
  const int rays = std::min(most_rays, affordable_rays(part));
  int m = 1;
  while (m < most_cuts && static_cast<long>(m + 1) * (m + 1) * count <= rays) ++m;
  const int stride = (count + rays - 1) / rays;
  const int starts = (count + stride - 1) / stride;
  return tbb::parallel_reduce(
      tbb::blocked_range<int>(0, starts, 64), std::numeric_limits<double>::infinity(),
      [&](const tbb::blocked_range<int>& range, double thinnest) {
        for (int i = range.begin(); i != range.end(); ++i) {
          thinnest = std::min(thinnest, wall_under(part, tree, i * stride, m));
        }
        return thinnest;
      },
      [](double a, double b) { return std::min(a, b); });
}

}  // namespace fingerpad
