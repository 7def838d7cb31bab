#pragma once

#include "part/part.hpp"

namespace fingerpad {

/// Which part of a triangle a closest point lies on. Edge k runs from corner k to corner k+1.
enum class Feature : unsigned char { face, edge0, edge1, edge2, vertex0, vertex1, vertex2 };

/// The closest point of one triangle.
struct TrianglePoint {
  Vec3 point = Vec3::Zero();
  double distance2_m2 = 0;
  Feature feature = Feature::face;
  Vec3 barycentric = Vec3::Zero();  ///< weights of corners 0, 1, 2
};

/// The point of triangle t of `part` that lies closest to q; both relative to the part's centre [m].
///
/// Edges are walked from the lower welded vertex to the higher, so that the triangles on both sides of an
/// edge give the same point and distance bit for bit. Slivers and triangles without area are safe: the face
/// counts only where its plane is well determined.
TrianglePoint closest_on_triangle(const Part& part, int t, const Vec3& q) noexcept;

}  // namespace fingerpad
