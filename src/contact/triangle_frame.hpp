#pragma once

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
  std::array<Vec3, 3>
      inward;  ///< unit, in the plane, from edge k into the triangle; zero where no plane is determined
  std::array<double, 3> inverse_length2;    ///< of edge k [1/m^2]; 0 for an edge without length
  std::array<std::uint8_t, 3> part_corner;  ///< corner k of the frame is this corner of the part's triangle
};

TriangleFrame triangle_frame(const Part& part, int t) noexcept;

/// Where on a frame a closest point lies. `site`: 0 face, 1 + k edge k, 4 + k corner k.
struct FramePoint {
  Vec3 point = Vec3::Zero();
  double distance2_m2 = 0;
  double along = 0;  ///< on an edge: 0 at its first corner, 1 at its second
  int site = 0;
};

namespace frame_detail {

inline constexpr int first_corner[3] = {0, 1, 0};
inline constexpr int second_corner[3] = {1, 2, 2};

inline FramePoint on_edge(const TriangleFrame& f, int k, const Vec3& q, double tie_m) noexcept {
  const int i = first_corner[k], j = second_corner[k];
  const Vec3 edge = f.corner[j] - f.corner[i];
  const double along = (q - f.corner[i]).dot(edge) * f.inverse_length2[k];
  FramePoint p;
  const double tie2 = tie_m * tie_m * f.inverse_length2[k];
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

/// Distances of q's projection from the three edges' lines, positive inside [m].
inline Vec3 inside_m(const TriangleFrame& f, const Vec3& q) noexcept {
  const Vec3 from0 = q - f.corner[0], from1 = q - f.corner[1];
  return {from0.dot(f.inward[0]), from1.dot(f.inward[1]), from0.dot(f.inward[2])};
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
  const Vec3 s = inside_m(f, q);
  if (s[0] > tie_m && s[1] > tie_m && s[2] > tie_m) {
    const int k = s[0] <= s[1] ? (s[0] <= s[2] ? 0 : 2) : (s[1] <= s[2] ? 1 : 2);
    FramePoint p = on_edge(f, k, q, tie_m);
    p.point += s[k] * f.inward[k];
    p.site = 0;
    p.distance2_m2 = (q - p.point).squaredNorm();
    return p;
  }
  FramePoint best;
  bool found = false;
  for (int k = 0; k < 3; ++k) {
    if (s[k] > tie_m) continue;
    const FramePoint p = on_edge(f, k, q, tie_m);
    if (!found || p.distance2_m2 < best.distance2_m2) best = p;
    found = true;
  }
  return best;
}

/// The same point in the terms of the part's triangle.
TrianglePoint in_part_corners(const TriangleFrame& f, const FramePoint& p, const Vec3& q) noexcept;

}  // namespace fingerpad
