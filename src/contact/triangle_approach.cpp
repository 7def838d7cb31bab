#include "contact/triangle_approach.hpp"

#include <cmath>
#include <limits>

namespace fingerpad {
namespace {

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

/// Of a point that is not over the face.
EdgeFoot nearest_edge_foot(const TriangleCorners& f, const FaceShares& shares, const Vec3& q) noexcept {
  const bool every = !(shares.area_m2 > regular_area_share * shares.sides2_m2);
  EdgeFoot best;
  if (every || !(shares.c > 0)) offer_edge(f.a, f.b, 0, q, best);
  if (every || !(shares.a > 0)) offer_edge(f.b, f.c, 1, q, best);
  if (every || !(shares.b > 0)) offer_edge(f.c, f.a, 2, q, best);
  return best;
}

}  // namespace

Feature nearest_feature(const TriangleCorners& f, const FaceShares& shares, const Vec3& q) noexcept {
  return shares.are_of_face() ? Feature::face : on_edge(nearest_edge_foot(f, shares, q)).feature;
}

bool has_face(const TriangleCorners& f) noexcept {
  return FaceShares(f, (f.a + f.b + f.c) / 3).are_of_face();
}

TriangleApproach approach_triangle(const TriangleCorners& f, const Vec3& q) noexcept {
  const Vec3& normal = f.normal;
  const FaceShares shares(f, q);
  TriangleApproach result;
  if (shares.are_of_face()) {
    const double height = normal.dot(q - f.a);
    result.at.point = q - height * normal;
    result.at.distance2_m2 = height * height;
    result.at.barycentric = Vec3(shares.a, shares.b, shares.c) / shares.area_m2;
    result.distance_m = std::abs(height);
    result.towards = height < 0 ? Vec3(-normal) : normal;
    return result;
  }
  result.at = on_edge(nearest_edge_foot(f, shares, q));
  result.distance_m = std::sqrt(result.at.distance2_m2);
  result.towards = result.distance_m > 0 ? Vec3((q - result.at.point) / result.distance_m) : normal;
  return result;
}

TriangleApproach approach_triangle(const Part& part, int t, const Vec3& q) noexcept {
  return approach_triangle(corners_of(part, t), q);
}

}  // namespace fingerpad
