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

Feature edge_between(int corner_a, int corner_b) noexcept {
  const int low = std::min(corner_a, corner_b), high = std::max(corner_a, corner_b);
  if (low == 0 && high == 2) return Feature::edge2;
  return low == 0 ? Feature::edge0 : Feature::edge1;
}

}  // namespace

std::array<int, 3> corner_order(const Part& part, int t) noexcept {
  std::array<int, 3> order = {0, 1, 2};
  const auto welded = part.welded.col(t);
  std::sort(order.begin(), order.end(),
            [&](int a, int b) { return std::make_pair(welded[a], a) < std::make_pair(welded[b], b); });
  return order;
}

/// The cross product of the two shorter edges, where rounding costs least; zero where rounding alone could
/// have made it.
Vec3 frame_normal(const std::array<Vec3, 3>& corner) noexcept {
  const Vec3 edge[3] = {corner[1] - corner[0], corner[2] - corner[1], corner[2] - corner[0]};
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

TriangleFrame triangle_frame(const Part& part, int t) noexcept {
  TriangleFrame f;
  const auto order = corner_order(part, t);
  for (int k = 0; k < 3; ++k) f.corner[k] = part.vertices.col(part.triangles(order[k], t));
  f.normal = frame_normal(f.corner);
  return f;
}

TrianglePoint in_part_corners(const FramePoint& p, const std::array<int, 3>& order) noexcept {
  TrianglePoint result;
  result.point = p.point;
  result.distance2_m2 = p.distance2_m2;
  if (p.site == 0) {
    const double whole = p.areas.sum();
    for (int k = 0; k < 3; ++k) result.barycentric[order[opposite_corner[k]]] = p.areas[k] / whole;
    result.feature = Feature::face;
  } else if (p.site <= 3) {
    const int first = order[first_corner[p.site - 1]], second = order[second_corner[p.site - 1]];
    result.barycentric[first] = 1 - p.along;
    result.barycentric[second] = p.along;
    result.feature = edge_between(first, second);
  } else {
    const int corner = order[p.site - 4];
    result.barycentric[corner] = 1;
    result.feature = static_cast<Feature>(static_cast<int>(Feature::vertex0) + corner);
  }
  return result;
}

TrianglePoint closest_on_triangle(const Part& part, int t, const Vec3& q) noexcept {
  return in_part_corners(closest_in(triangle_frame(part, t), q, tie_distance_m(part, q)),
                         corner_order(part, t));
}

}  // namespace fingerpad
