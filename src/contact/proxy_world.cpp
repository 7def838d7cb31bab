#include "contact/proxy_world.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "contact/proxy_limits.hpp"

namespace fingerpad {

ProxyWorld::ProxyWorld(std::vector<PlacedSurface> surfaces, double radius_m, Normals normals)
    : surfaces_(std::move(surfaces)), radius_m_(radius_m), normals_(normals) {
  for (int i = 0; i < surface_count(); ++i) {
    (surface(i).is_plane() ? planes_ : parts_).push_back(i);
    is_upright_.push_back(surface(i).R_WP == Mat3::Identity());
    middle_O_.push_back(surface(i).kind().middle_W(surface(i)));
  }
  if (!middle_O_.empty()) p_WO_ = middle_O_[parts_.empty() ? 0 : static_cast<std::size_t>(parts_.front())];
  for (Vec3& middle_O : middle_O_) {
    middle_O -= p_WO_;
    middles_m_ = std::max(middles_m_, middle_O.cwiseAbs().maxCoeff());
  }
  for (const int i : parts_) {
    const double to_middle_m = middle_O_[static_cast<std::size_t>(i)].norm();
    extent_m_ = std::max(extent_m_, to_middle_m + part(i).half_extent.norm());
  }
  skin_m_ = std::ldexp(extent_m_, ProxyLimits::skin_exponent);
  tolerance_m_ = std::ldexp(skin_m_, ProxyLimits::tolerance_exponent);
  slack_m_ = std::ldexp(tolerance_m_, ProxyLimits::slack_exponent);
  touching_m_ = ProxyLimits::touching_tolerances * tolerance_m_;
}

double ProxyWorld::plane_rounding_m(const Vec3& place_O, const Vec3& goal_O) const noexcept {
  if (extent_m_ > 0) return 0;
  const double farther_m = std::max(place_O.cwiseAbs().maxCoeff(), goal_O.cwiseAbs().maxCoeff());
  return ProxyLimits::plane_rounding * (farther_m + middles_m_ + radius_m_);
}

Vec3 ProxyWorld::in_part(int i, const Vec3& place_O) const noexcept {
  return turned_into_part(i, place_O - middle_O_[static_cast<std::size_t>(i)]);
}

Vec3 ProxyWorld::from_part(int i, const Vec3& q_P) const noexcept {
  return turned_from_part(i, q_P) + middle_O_[static_cast<std::size_t>(i)];
}

const TriangleApproach& ProxyWorld::approach(int i, int triangle, const Vec3& place_O) const noexcept {
  return approaches_.find_or_keep(i, triangle, place_O,
                                  [&] { return approach_triangle(part(i), triangle, in_part(i, place_O)); });
}

bool ProxyWorld::is_far_from(const ProxyWall& wall, const Vec3& place_O) const noexcept {
  const double far_m =
      std::min(ProxyLimits::far_wall * extent_m_, ProxyLimits::far_wall_share * clearance_m());
  return wall.triangle >= 0 &&
         approach(wall.surface, wall.triangle, place_O).distance_m > clearance_m() + far_m;
}

bool ProxyWorld::is_own_plane(const ProxyWall& wall) const noexcept {
  const Vec3 normal = turned_from_part(wall.surface, part(wall.surface).facet_normals.col(wall.triangle));
  return wall.normal.cross(normal).squaredNorm() <= ProxyLimits::same_wall * ProxyLimits::same_wall;
}

ProxyWall ProxyWorld::plane_wall(int i, const Vec3& place_O) const noexcept {
  const Vec3& normal = surface(i).plane_normal_W;
  return {normal, clearance_m() - normal.dot(place_O - middle_O_[static_cast<std::size_t>(i)]), i, -1};
}

ProxyWall ProxyWorld::tangent_wall(int i, int triangle, const Vec3& from_O,
                                   const Vec3& place_O) const noexcept {
  const TriangleApproach& from = approach(i, triangle, from_O);
  const Vec3 normal = turned_from_part(i, from.towards);
  return {normal, clearance_m() - from.distance_m + normal.dot(from_O - place_O), i, triangle};
}

}  // namespace fingerpad
