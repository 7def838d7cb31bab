#include "view/stick_region.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/tangent_frame.hpp"
#include "contact/placed_surface.hpp"
#include "friction/law_table.hpp"

namespace fingerpad {

std::optional<StickAxes> stick_axes(const FrictionSettings& friction, const SurfaceProperties& surface,
                                    double inclination_rad) {
  const LawEntry* law = find_law(friction.law);
  if (law == nullptr || law->stick_axes == nullptr) return std::nullopt;
  return law->stick_axes(friction.settings, surface.mu_static, inclination_rad);
}

Vec3 finger_direction(const Vec3& scene_direction_W, const TickRecord& row) {
  if (row.phase == Phase::free || !std::isfinite(row.inclination_rad)) return scene_direction_W;
  const Vec3 along = tangent_frame(row.normal_W, scene_direction_W).col(1);
  return std::cos(row.inclination_rad) * along - std::sin(row.inclination_rad) * row.normal_W;
}

std::optional<StickRegion> stick_region(const Scene& scene, const SurfaceProperties& surface,
                                        const TickRecord& row) {
  if (row.phase == Phase::free) return std::nullopt;
  const auto axes = stick_axes(scene.friction, surface, row.inclination_rad);
  if (!axes || !(axes->lateral_m > 0) || !(axes->longitudinal_m > 0)) return std::nullopt;
  const Mat3 frame = tangent_frame(row.normal_W, scene.finger.direction);
  StickRegion region{*axes, row.stick_centre_W, frame.col(0), frame.col(1)};
  if (row.phase == Phase::stick && row.stick_centre_W.allFinite()) return region;
  // f = -mu_s n (d_x/a, d_y/b), solved for the displacement d from the centre.
  const double limit_n = surface.mu_static * row.normal_force_n;
  if (!(limit_n > 0)) return std::nullopt;
  region.centre_W =
      row.contact_W +
      region.lateral_W * (row.friction_W_n.dot(region.lateral_W) * axes->lateral_m / limit_n) +
      region.longitudinal_W * (row.friction_W_n.dot(region.longitudinal_W) * axes->longitudinal_m / limit_n);
  return region;
}

std::vector<Vec3> rim_points(const StickRegion& region, int count, double share) {
  std::vector<Vec3> points;
  points.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    points.emplace_back(region.centre_W + share * region.axes.lateral_m * std::cos(angle) * region.lateral_W +
                        share * region.axes.longitudinal_m * std::sin(angle) * region.longitudinal_W);
  }
  return points;
}

std::vector<std::vector<Vec3>> region_rings(const StickRegion& region, const Surface& surface) {
  constexpr int rings = 5, around = 60;
  const double reach_m = 2 * std::max(region.axes.lateral_m, region.axes.longitudinal_m);
  std::vector<std::vector<Vec3>> all;
  int seed = -1;
  for (int ring = 1; ring <= rings; ++ring) {
    all.push_back(rim_points(region, around, static_cast<double>(ring) / rings));
    if (surface.part && !surface.tree) continue;
    for (Vec3& point : all.back()) {
      const WorldPoint at = nearest_point(surface, point, Normals::facet, seed, reach_m);
      if (!at.found) continue;
      seed = at.triangle;
      point = at.point_W;
    }
  }
  return all;
}

}  // namespace fingerpad
