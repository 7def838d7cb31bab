#include "contact/proxy_start.hpp"

#include <cmath>

#include "contact/surface_point.hpp"

namespace fingerpad {
namespace {

/// Between walls that lean towards each other every push halves what is missing, or more.
constexpr int most_pushes = 200;

/// How much a place lacks of the clearance, and which way out is.
struct Lack {
  double lack_m = 0;
  Vec3 outwards_W = Vec3::UnitZ();
};

Lack lack_at(const ProxySurroundings& around, int surface, const Vec3& place) noexcept {
  const ProxySurface& s = around.surfaces()[static_cast<std::size_t>(surface)];
  if (!s.tree) {
    const ProxyWall wall = around.plane_wall(surface, place);
    return {wall.least_m, wall.normal};
  }
  const Part& part = s.tree->part();
  const Vec3 q = around.in_part(surface, place);
  const SurfacePoint near =
      nearest_surface_point(*s.tree, q + part.centre_P, Normals::facet, -1, around.clearance_m());
  if (near.triangle < 0) return {-1, Vec3::UnitZ()};
  const bool behind = near.signed_distance_m < 0;
  const bool inside = behind && s.tree->encloses(q);
  if (behind && !inside) return {around.clearance_m() + near.signed_distance_m, s.R_WP * (-near.normal_P)};
  return {around.clearance_m() - near.signed_distance_m, s.R_WP * near.normal_P};
}

}  // namespace

std::optional<Vec3> proxy_start(const ProxySurroundings& around, const Vec3& goal) noexcept {
  Vec3 place = goal;
  for (int push = 0; push < most_pushes; ++push) {
    Lack worst{around.tolerance_m(), Vec3::UnitZ()};
    bool found = false;
    for (int surface = 0; surface < static_cast<int>(around.surfaces().size()); ++surface) {
      // The pushes go outwards, and where they lead into another surface, out of that again.
      const Lack lack = lack_at(around, surface, place);
      if (lack.lack_m > worst.lack_m) {
        worst = lack;
        found = true;
      }
    }
    if (!found) return place;
    place += worst.lack_m * worst.outwards_W;
  }
  return std::nullopt;
}

}  // namespace fingerpad
