#include "contact/closest_point.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "contact/triangle_frame.hpp"

namespace fingerpad {
namespace {

using frame_detail::first_corner;
using frame_detail::second_corner;

/// The corner of three that edge k of a frame does not touch.
constexpr int opposite_corner[3] = {2, 0, 1};

/// A normal, not unit: the cross product of the two shorter edges, where rounding costs least. Zero where
/// rounding alone could have made it.
Vec3 plane_normal(const TriangleFrame& f) noexcept {
  const Vec3 edge[3] = {f.corner[1] - f.corner[0], f.corner[2] - f.corner[1], f.corner[2] - f.corner[0]};
  const double length[3] = {edge[0].norm(), edge[1].norm(), edge[2].norm()};
  const int longest = static_cast<int>(std::max_element(length, length + 3) - length);
  const int a = (longest + 1) % 3, b = (longest + 2) % 3;
  const auto normal = edge[a].cast<long double>().cross(edge[b].cast<long double>()).eval();
  const long double size = normal.norm();
  constexpr double rounding = 1e-15;
  if (!(size > rounding * length[a] * length[b])) return Vec3::Zero();
  // As (corner 1 - corner 0) x (corner 2 - corner 0): with edge 2 = edge 0 + edge 1 the other two pairs are
  // turned round.
  return (normal / (longest == 2 ? size : -size)).cast<double>();
}

/// The unit vector in the plane that points from edge k into the triangle; zero without a plane. Which way
/// that is follows from the order of the corners; a sliver's opposite corner is too near to ask.
Vec3 inward_of(const TriangleFrame& f, int k, const Vec3& unit_normal) noexcept {
  const Vec3 edge = f.corner[second_corner[k]] - f.corner[first_corner[k]];
  const Vec3 across = unit_normal.cross(edge).stableNormalized();
  return k == 2 ? Vec3(-across) : across;
}

Feature edge_between(int corner_a, int corner_b) noexcept {
  const int low = std::min(corner_a, corner_b), high = std::max(corner_a, corner_b);
  if (low == 0 && high == 2) return Feature::edge2;
  return low == 0 ? Feature::edge0 : Feature::edge1;
}

}  // namespace

TriangleFrame triangle_frame(const Part& part, int t) noexcept {
  TriangleFrame f;
  int order[3] = {0, 1, 2};
  const auto welded = part.welded.col(t);
  std::sort(order, order + 3,
            [&](int a, int b) { return std::make_pair(welded[a], a) < std::make_pair(welded[b], b); });
  for (int k = 0; k < 3; ++k) {
    f.part_corner[k] = static_cast<std::uint8_t>(order[k]);
    f.corner[k] = part.vertices.col(part.triangles(order[k], t));
  }
  const Vec3 unit_normal = plane_normal(f);
  for (int k = 0; k < 3; ++k) {
    const double length2 = (f.corner[second_corner[k]] - f.corner[first_corner[k]]).squaredNorm();
    f.inverse_length2[k] = length2 > 0 && std::isfinite(1 / length2) ? 1 / length2 : 0;
    f.inward[k] = inward_of(f, k, unit_normal);
  }
  return f;
}

TrianglePoint in_part_corners(const TriangleFrame& f, const FramePoint& p, const Vec3& q) noexcept {
  TrianglePoint result;
  result.point = p.point;
  result.distance2_m2 = p.distance2_m2;
  if (p.site == 0) {
    const Vec3 s = frame_detail::inside_m(f, q);
    Vec3 weight;  // of the corner opposite an edge: that edge's length times the distance from it
    for (int k = 0; k < 3; ++k) weight[opposite_corner[k]] = s[k] / std::sqrt(f.inverse_length2[k]);
    weight /= weight.sum();
    for (int k = 0; k < 3; ++k) result.barycentric[f.part_corner[k]] = weight[k];
    result.feature = Feature::face;
  } else if (p.site <= 3) {
    const int first = f.part_corner[first_corner[p.site - 1]],
              second = f.part_corner[second_corner[p.site - 1]];
    result.barycentric[first] = 1 - p.along;
    result.barycentric[second] = p.along;
    result.feature = edge_between(first, second);
  } else {
    const int corner = f.part_corner[p.site - 4];
    result.barycentric[corner] = 1;
    result.feature = static_cast<Feature>(static_cast<int>(Feature::vertex0) + corner);
  }
  return result;
}

TrianglePoint closest_on_triangle(const Part& part, int t, const Vec3& q) noexcept {
  const TriangleFrame f = triangle_frame(part, t);
  return in_part_corners(f, closest_in(f, q, tie_distance_m(part, q)), q);
}

}  // namespace fingerpad
