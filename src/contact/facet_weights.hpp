#pragma once

#include <Eigen/Geometry>

#include "contact/proxy_world.hpp"

namespace fingerpad {

/// The weights of a facet's corners at the foot of a place, which change evenly with the place.
class FacetWeights {
 public:
  FacetWeights() = default;
  FacetWeights(const ProxyWorld& world, const ProxyWall& wall) noexcept {
    if (wall.triangle < 0) return;
    const Mat3& R_WP = world.surface(wall.surface).R_WP;
    const TriangleCorners f = corners_of(world.part(wall.surface), wall.triangle);
    const Vec3 ab = f.b - f.a, ac = f.c - f.a;
    const double area = f.normal.dot(ab.cross(ac));
    corner_O_ = world.from_part(wall.surface, f.a);
    per_place_.row(1) = R_WP * (ac.cross(f.normal) / area);
    per_place_.row(2) = R_WP * (f.normal.cross(ab) / area);
    per_place_.row(0) = -per_place_.row(1) - per_place_.row(2);
  }

  Vec3 at(const Vec3& place_O) const noexcept { return per_place_ * (place_O - corner_O_) + Vec3::UnitX(); }

 private:
  Vec3 corner_O_ = Vec3::Zero();   // the facet's first, where they are 1, 0, 0 ...
  Mat3 per_place_ = Mat3::Zero();  // ... and how they change with the place from there, a row each
};

}  // namespace fingerpad
