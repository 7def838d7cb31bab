#pragma once

#include <Eigen/Geometry>

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

/// The feature that approach_triangle finds the closest point on.
/// @param shares  of q
Feature nearest_feature(const TriangleCorners& triangle, const FaceShares& shares, const Vec3& q) noexcept;

}  // namespace fingerpad
