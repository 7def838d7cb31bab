#include "touch/finger_room.hpp"

#include <algorithm>
#include <cmath>

namespace fingerpad {

NearestSurface nearest_surface(const World& world, const Vec3& p_W, Normals normals,
                               double reach_m) noexcept {
  NearestSurface nearest;
  nearest.clear_m = reach_m;
  for (std::size_t i = 0; i < world.surfaces.size(); ++i) {
    const Surface& surface = world.surfaces[i];
    if (surface.part && !surface.tree) continue;
    const WorldPoint at = nearest_point(surface, p_W, normals, -1, reach_m);
    if (!at.found) continue;
    // Behind an open part one is as free as before it.
    const bool has_inside = surface.is_plane() || (i < world.verdicts.size() && world.verdicts[i].closed);
    const double clear_m = has_inside ? at.signed_distance_m : std::abs(at.signed_distance_m);
    if (nearest.surface >= 0 && clear_m >= nearest.clear_m) continue;
    nearest = {at, static_cast<int>(i), clear_m};
  }
  return nearest;
}

/// Each time by as much as is free, until hardly anything is.
Vec3 stopped_on_line(const World& world, const Vec3& spot_W, const Vec3& up_W, double from_m, double radius_m,
                     double hardly_m) noexcept {
  constexpr int most_looks = 40;
  double up_m = std::max(0.0, from_m);
  for (int i = 0; i < most_looks && up_m > 0; ++i) {
    const Vec3 place_W = spot_W + up_m * up_W;
    const double free_m = nearest_surface(world, place_W, Normals::facet, radius_m + up_m).clear_m - radius_m;
    if (free_m < hardly_m) break;
    up_m = std::max(0.0, up_m - free_m);
  }
  return spot_W + up_m * up_W;
}

}  // namespace fingerpad
