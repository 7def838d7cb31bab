#include "contact/triangle_approach.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace fingerpad {
namespace {

/// A triangle whose area is smaller than this share of its sides' squares is no more than its edges: its
/// width is then far below any clearance.
constexpr double least_area_share = 1e-13;
/// From so large a share on, the sides' order about a point is known to rounding, and only edges that the
/// point is outside of are looked at.
constexpr double regular_area_share = 1e-4;

/// The closest point of an edge.
struct EdgeFoot {
  Vec3 point = Vec3::Zero();
  double distance2_m2 = std::numeric_limits<double>::infinity();
  double share = 0;  ///< 0 at its first corner, 1 at its second
  int edge = 0;
};

/// Offers the closest point of the edge from corner k at `a` to the next at `b`.
void offer_edge(const Vec3& a, const Vec3& b, int k, const Vec3& q, EdgeFoot& best) noexcept {
  const Vec3 along = b - a;
  const double length2 = along.squaredNorm(), dot = (q - a).dot(along);
  const double share = !(dot > 0) ? 0 : dot >= length2 ? 1 : dot / length2;
  const Vec3 point = share < 1 ? Vec3(a + share * along) : b;
  const double distance2_m2 = (q - point).squaredNorm();
  if (distance2_m2 < best.distance2_m2) best = {point, distance2_m2, share, k};
}

TrianglePoint on_edge(const EdgeFoot& foot) noexcept {
  TrianglePoint p;
  const int next = (foot.edge + 1) % 3;
  p.point = foot.point;
  p.distance2_m2 = foot.distance2_m2;
  p.barycentric[foot.edge] = 1 - foot.share;
  p.barycentric[next] = foot.share;
  if (foot.share > 0 && foot.share < 1) {
    p.feature = static_cast<Feature>(static_cast<int>(Feature::edge0) + foot.edge);
  } else {
    p.feature =
        static_cast<Feature>(static_cast<int>(Feature::vertex0) + (foot.share > 0 ? next : foot.edge));
  }
  return p;
}

}  // namespace

TriangleCorners corners_of(const Part& part, int t) noexcept {
  return {part.vertices.col(part.triangles(0, t)), part.vertices.col(part.triangles(1, t)),
          part.vertices.col(part.triangles(2, t)), part.facet_normals.col(t)};
}

TriangleApproach approach_triangle(const TriangleCorners& f, const Vec3& q) noexcept {
  const Vec3 &normal = f.normal, ab = f.b - f.a, bc = f.c - f.b, ca = f.a - f.c;
  const Vec3 aq = q - f.a, bq = q - f.b, cq = q - f.c;
  const double c_share = normal.dot(ab.cross(aq)), a_share = normal.dot(bc.cross(bq)),
               b_share = normal.dot(ca.cross(cq));
  const double area = a_share + b_share + c_share,
               sides2 = ab.squaredNorm() + bc.squaredNorm() + ca.squaredNorm();
  TriangleApproach result;
  if (a_share > 0 && b_share > 0 && c_share > 0 && area > least_area_share * sides2) {
    const double height = normal.dot(aq);
    result.at.point = q - height * normal;
    result.at.distance2_m2 = height * height;
    result.at.barycentric = Vec3(a_share, b_share, c_share) / area;
    result.distance_m = std::abs(height);
    result.towards = height < 0 ? Vec3(-normal) : normal;
    return result;
  }
  const bool every = !(area > regular_area_share * sides2);
  EdgeFoot best;
  if (every || !(c_share > 0)) offer_edge(f.a, f.b, 0, q, best);
  if (every || !(a_share > 0)) offer_edge(f.b, f.c, 1, q, best);
  if (every || !(b_share > 0)) offer_edge(f.c, f.a, 2, q, best);
  result.at = on_edge(best);
  result.distance_m = std::sqrt(result.at.distance2_m2);
  result.towards = result.distance_m > 0 ? Vec3((q - result.at.point) / result.distance_m) : normal;
  return result;
}

TriangleApproach approach_triangle(const Part& part, int t, const Vec3& q) noexcept {
  return approach_triangle(corners_of(part, t), q);
}

}  // namespace fingerpad
