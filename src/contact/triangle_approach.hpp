#pragma once

#include <Eigen/Geometry>
#include <algorithm>

#include "contact/closest_point.hpp"
#include "contact/proxy_limits.hpp"

namespace fingerpad {

/// How a point stands before a triangle, from whichever side.
struct TriangleApproach {
  TrianglePoint at;              ///< closest point of the triangle
  Vec3 towards = Vec3::UnitZ();  ///< unit, from there to the point; over the face the facet's normal, turned
                                 ///< to the point's side
  double distance_m = 0;
};

/// A triangle at hand: what the sweeps read of a part.
struct TriangleCorners {
  Vec3 a, b, c;  ///< relative to the part's centre [m]
  Vec3 normal;   ///< Part::facet_normals
};

inline TriangleCorners corners_of(const Part& part, int t) noexcept {
  return {part.vertices.col(part.triangles(0, t)), part.vertices.col(part.triangles(1, t)),
          part.vertices.col(part.triangles(2, t)), part.facet_normals.col(t)};
}

/// Whether a triangle is more than its edges: else no point of it counts as one of its face.
bool has_face(const TriangleCorners& triangle) noexcept;

/// The closest point of triangle t to q, relative to the part's centre, without the ties' bookkeeping of
/// closest_on_triangle: exact to rounding. noexcept, allocates nothing.
TriangleApproach approach_triangle(const Part& part, int t, const Vec3& q) noexcept;
TriangleApproach approach_triangle(const TriangleCorners& triangle, const Vec3& q) noexcept;

/// What share of a triangle lies opposite to each corner, seen from a point's foot: all above 0 over the
/// face.
struct FaceShares {
  double a, b, c;             ///< twice the areas [m^2]
  double area_m2, sides2_m2;  ///< their sum; the sides' squares

  FaceShares(const TriangleCorners& f, const Vec3& q) noexcept {
    const Vec3 ab = f.b - f.a, bc = f.c - f.b, ca = f.a - f.c;
    c = f.normal.dot(ab.cross(q - f.a));
    a = f.normal.dot(bc.cross(q - f.b));
    b = f.normal.dot(ca.cross(q - f.c));
    area_m2 = a + b + c;
    sides2_m2 = ab.squaredNorm() + bc.squaredNorm() + ca.squaredNorm();
  }

  bool are_of_face() const noexcept {
    return a > 0 && b > 0 && c > 0 && area_m2 > ProxyLimits::face_area_share * sides2_m2;
  }
};

/// A facet seen from a point, reckoned once for all that is asked of it.
struct FacetView {
  TriangleCorners facet;
  Vec3 q;
  FaceShares shares;

  FacetView(const Part& part, int t, const Vec3& from) noexcept
      : facet(corners_of(part, t)), q(from), shares(facet, from) {}

  /// Whether the closest point of the facet, as approach_triangle finds it, is on its face.
  /// @param foot  that point, written where it is
  bool find_foot(Vec3& foot) const noexcept {
    if (!shares.are_of_face()) return false;
    foot = q - facet.normal.dot(q - facet.a) * facet.normal;
    return true;
  }
  /// The feature that approach_triangle finds the closest point on.
  Feature nearest_feature() const noexcept;
  /// The edge, as Part::neighbours counts them, beyond which a place beside the facet lies: of two that
  /// with the larger triangle between.
  int edge_farthest_behind() const noexcept;
  /// Whether the point is beside the face by more than `off_m` [m], whatever that loses in rounding.
  bool is_surely_beside(double off_m) const noexcept {
    const double least = std::min({shares.a, shares.b, shares.c});
    return least < 0 && least * least > off_m * off_m * shares.sides2_m2;
  }
};

}  // namespace fingerpad
