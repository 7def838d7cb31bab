#include "contact/bent_walls.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "contact/facet_rule.hpp"
#include "contact/proxy_limits.hpp"

namespace fingerpad {
namespace {

/// By how much of a way the share of a wall, which turns with it, draws the finger's foot on: the wall's
/// curvature times its share. Zero where it is flat.
Mat3 bend_of(const ProxyWorld& world, const ProxyWall& wall, double share_m, const Vec3& place_O) noexcept {
  if (wall.triangle < 0) return Mat3::Zero();
  if (world.is_own_plane(wall)) return Mat3::Zero();  // also beside its face
  const TriangleApproach& a = world.approach(wall.surface, wall.triangle, place_O);
  if (a.at.feature == Feature::face) return Mat3::Zero();
  const double bend = share_m / world.clearance_m();
  if (a.at.feature >= Feature::vertex0)
    return bend * (Mat3::Identity() - wall.normal * wall.normal.transpose());
  const int k = edge_of(a.at.feature);
  const Part& part = world.part(wall.surface);
  const Vec3 edge_P = part.vertices.col(part.triangles((k + 1) % 3, wall.triangle)) -
                      part.vertices.col(part.triangles(k, wall.triangle));
  const Vec3 across = wall.normal.cross(world.turned_from_part(wall.surface, edge_P)).normalized();
  return bend * across * across.transpose();
}

}  // namespace

Vec3 way_along_bend(const ProxyWorld& world, const ProxyStep& step) noexcept {
  if (step.wall_count < 1 || step.wall_count > 2) return Vec3::Zero();
  Mat3 bend = Mat3::Zero();
  for (std::size_t k = 0; k < step.held_by().size(); ++k)
    bend += bend_of(world, step.walls[k], step.share_m[k], step.from_O + step.z);
  if (bend.isZero(0)) return Vec3::Zero();
  const Vec3& normal = step.walls[0].normal;
  if (step.wall_count == 2) {
    const Vec3 along = normal.cross(step.walls[1].normal).normalized();
    const double left = 1 - along.dot(bend * along);
    if (!(left > ProxyLimits::least_left_of_bend)) return Vec3::Zero();
    return along.dot(bend * step.z) / left * along;
  }
  const Vec3 one = normal.unitOrthogonal(), other = normal.cross(one);
  const double a = 1 - one.dot(bend * one), b = -one.dot(bend * other), c = 1 - other.dot(bend * other);
  const double determinant = a * c - b * b;
  if (!(std::min(a, c) > 0 && determinant > ProxyLimits::least_left_of_bend * (a + c))) return Vec3::Zero();
  const Vec3 missing = bend * step.z;
  const double along_one = one.dot(missing), along_other = other.dot(missing);
  return ((c * along_one - b * along_other) * one + (a * along_other - b * along_one) * other) / determinant;
}

}  // namespace fingerpad
