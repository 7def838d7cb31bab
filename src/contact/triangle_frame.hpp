#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>

#include "contact/closest_point.hpp"

namespace fingerpad {

/// One triangle prepared for closest-point queries, in the frame of Part::vertices.
///
/// Corners are sorted by welded vertex, so that an edge runs from the lower vertex to the higher in both of
/// its triangles and gives both the same bits. Edge 0 joins corners 0 and 1, edge 1 corners 1 and 2, edge 2
/// corners 0 and 2.
struct TriangleFrame {
  std::array<Vec3, 3> corner;  ///< [m]
  Vec3 normal;                 ///< unit, as the corners' order has it; zero where no plane is determined
};

/// Which corners of the part's triangle t are corners 0, 1, 2 of its frame.
std::array<int, 3> corner_order(const Part& part, int t) noexcept;

/// A frame's normal, see TriangleFrame.
Vec3 frame_normal(const std::array<Vec3, 3>& corner) noexcept;

TriangleFrame triangle_frame(const Part& part, int t) noexcept;

/// Where on a frame a closest point lies. `site`: 0 face, 1 + k edge k, 4 + k corner k.
struct FramePoint {
  Vec3 point = Vec3::Zero();
  double distance2_m2 = 0;
  double along = 0;  ///< on an edge: 0 at its first corner, 1 at its second
  int site = 0;
  Vec3 areas = Vec3::Zero();  ///< on the face: twice the areas that the point spans with edges 0, 1, 2 [m^2]
};

namespace frame_detail {

inline constexpr int first_corner[3] = {0, 1, 0};
inline constexpr int second_corner[3] = {1, 2, 2};

inline FramePoint on_edge(const TriangleFrame& f, int k, const Vec3& q, double tie_m) noexcept {
  const int i = first_corner[k], j = second_corner[k];
  const Vec3 edge = f.corner[j] - f.corner[i];
  const double length2 = edge.squaredNorm();
  const double inverse_length2 = length2 > 0 && length2 > 1e-300 ? 1 / length2 : 0;
  const double along = (q - f.corner[i]).dot(edge) * inverse_length2;
  FramePoint p;
  const double tie2 = tie_m * tie_m * inverse_length2;
  if (along <= 0 || along * along <= tie2) {
    p.point = f.corner[i];
    p.site = 4 + i;
  } else if (along >= 1 || (1 - along) * (1 - along) <= tie2) {
    p.point = f.corner[j];
    p.site = 4 + j;
  } else {
    p.point = f.corner[i] + along * edge;
    p.site = 1 + k;
    p.along = along;
  }
  p.distance2_m2 = (q - p.point).squaredNorm();
  return p;
}

}  // namespace frame_detail

/// How near to an edge or a corner rounding cannot tell a point from one on it [m]: a few units in the last
/// place. Points that near are taken to lie on it, so that all triangles there give the same bits and the
/// lowest wins.
inline double tie_distance_m(const Part& part, const Vec3& q) noexcept {
  return 5e-16 * (part.half_extent.maxCoeff() + q.cwiseAbs().maxCoeff());
}

/// The point of a frame's triangle that lies closest to q; `tie_m` is tie_distance_m(part, q).
///
/// The projection lies inside where it is inside of all three edges; it is then built from the foot on the
/// nearest edge, so that a sliver's badly known normal is multiplied by its small width and costs no more
/// than rounding. Elsewhere the closest point lies on an edge that q is outside of; without a plane that is
/// every edge.
inline FramePoint closest_in(const TriangleFrame& f, const Vec3& q, double tie_m) noexcept {
  using namespace frame_detail;
  // Into the triangle from each edge, as long as that edge.
  const Vec3 edge[3] = {f.corner[1] - f.corner[0], f.corner[2] - f.corner[1], f.corner[2] - f.corner[0]};
  const Vec3 inward[3] = {f.normal.cross(edge[0]), f.normal.cross(edge[1]), edge[2].cross(f.normal)};
  const Vec3 from0 = q - f.corner[0];
  const Vec3 area(from0.dot(inward[0]), (q - f.corner[1]).dot(inward[1]), from0.dot(inward[2]));
  const Vec3 length2(edge[0].squaredNorm(), edge[1].squaredNorm(), edge[2].squaredNorm());
  const auto inside = [&](int k) { return area[k] > 0 && area[k] * area[k] > tie_m * tie_m * length2[k]; };
  if (inside(0) && inside(1) && inside(2)) {
    const auto nearer = [&](int i, int j) {
      return area[i] * area[i] * length2[j] <= area[j] * area[j] * length2[i];
    };
    const int k = nearer(0, 1) ? (nearer(0, 2) ? 0 : 2) : (nearer(1, 2) ? 1 : 2);
    FramePoint p;
    const double inverse_length2 = 1 / length2[k];
    const Vec3& first = f.corner[first_corner[k]];
    p.point =
        first + (q - first).dot(edge[k]) * inverse_length2 * edge[k] + area[k] * inverse_length2 * inward[k];
    p.distance2_m2 = (q - p.point).squaredNorm();
    p.areas = area;
    return p;
  }
  FramePoint best;
  bool found = false;
  for (int k = 0; k < 3; ++k) {
    if (inside(k)) continue;
    const FramePoint p = on_edge(f, k, q, tie_m);
    if (!found || p.distance2_m2 < best.distance2_m2) best = p;
    found = true;
  }
  return best;
}

/// The same point in the terms of the part's triangle; `order` is corner_order(part, t).
TrianglePoint in_part_corners(const FramePoint& p, const std::array<int, 3>& order) noexcept;

}  // namespace fingerpad
