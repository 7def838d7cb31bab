#include "contact/proxy_start.hpp"

#include <array>
#include <cmath>

#include "contact/proxy_limits.hpp"
#include "contact/surface_point.hpp"

namespace fingerpad {
namespace {

/// How much a place lacks of the clearance, and which way out is.
struct Lack {
  double lack_m = 0;
  Vec3 outwards_W = Vec3::UnitZ();
};

Lack lack_at(const ProxyWorld& world, int surface, const Vec3& place_O) noexcept {
  if (world.is_plane(surface)) {
    const ProxyWall wall = world.plane_wall(surface, place_O);
    return {wall.least_m, wall.normal};
  }
  const PlacedSurface& s = world.surface(surface);
  const Part& part = s.tree->part();
  const Vec3 q_P = world.in_part(surface, place_O);
  const SurfacePoint near =
      nearest_surface_point(*s.tree, q_P + part.centre_P, Normals::facet, -1, world.clearance_m());
  if (near.triangle < 0) return {-1, Vec3::UnitZ()};
  const bool behind = near.signed_distance_m < 0;
  const bool inside = behind && s.tree->encloses(q_P);
  if (behind && !inside) return {world.clearance_m() + near.signed_distance_m, s.R_WP * (-near.normal_P)};
  return {world.clearance_m() - near.signed_distance_m, s.R_WP * near.normal_P};
}

/// The nearest place that keeps the clearance from every plane, by the dual active-set method: the plane that
/// is breached most is added until none is.
std::optional<Vec3> out_of_planes(const ProxyWorld& world, const Vec3& goal_O) noexcept {
  std::array<ProxyWall, 4> walls;
  std::size_t count = 0;
  Vec3 place_O = goal_O;
  for (int pass = 0; pass < ProxyLimits::most_passes; ++pass) {
    const double slack_m = world.plane_rounding_m(place_O);
    double worst_m = 2 * slack_m;
    int worst = -1;
    for (int i = 0; i < world.surface_count(); ++i) {
      const double lack_m = world.plane_wall(i, place_O).least_m;
      if (!(lack_m > worst_m)) continue;
      worst_m = lack_m;
      worst = i;
    }
    if (worst < 0) return place_O;
    walls[count++] = world.plane_wall(worst, goal_O);
    const ProxyProjection p = project_onto_walls(Vec3::Zero(), std::span(walls.data(), count), slack_m);
    if (!p.found) return std::nullopt;
    count = static_cast<std::size_t>(p.active_count);
    for (std::size_t k = 0; k < count; ++k) walls[k] = walls[static_cast<std::size_t>(p.active[k])];
    place_O = goal_O + p.z;
  }
  return std::nullopt;
}

}  // namespace

std::optional<Vec3> proxy_start(const ProxyWorld& world, const Vec3& goal_O) noexcept {
  if (!(world.extent_m() > 0)) return out_of_planes(world, goal_O);
  Vec3 place_O = goal_O;
  for (int push = 0; push < ProxyLimits::most_pushes; ++push) {
    Lack worst{world.tolerance_m(), Vec3::UnitZ()};
    bool found = false;
    for (int surface = 0; surface < world.surface_count(); ++surface) {
      // The pushes go outwards, and where they lead into another surface, out of that again.
      const Lack lack = lack_at(world, surface, place_O);
      if (lack.lack_m > worst.lack_m) {
        worst = lack;
        found = true;
      }
    }
    if (!found) return place_O;
    place_O += worst.lack_m * worst.outwards_W;
  }
  return std::nullopt;
}

}  // namespace fingerpad
