#include "touch/finger_room.hpp"

#include <algorithm>
#include <cmath>

#include "contact/triangle_tree.hpp"

namespace fingerpad {

NearestSurface nearest_surface(const World& world, const Vec3& p_W, Normals normals, double reach_m,
                               Looks& looks) noexcept {
  NearestSurface nearest;
  nearest.clear_m = reach_m;
  for (std::size_t i = 0; i < world.surfaces.size(); ++i) {
    const Surface& surface = world.surfaces[i];
    if (surface.part && !surface.tree) continue;
    BriefSearch brief{std::max(1L, looks.left())};
    const WorldPoint at = nearest_point(surface, p_W, normals, brief, reach_m);
    looks.spend(brief.spent);
    if (brief.broken_off) nearest.is_sure = false;
    if (!at.found) continue;
    // Behind an open part one is as free as before it.
    const bool has_inside = surface.is_plane() || (i < world.verdicts.size() && world.verdicts[i].closed);
    const double clear_m = has_inside ? at.signed_distance_m : std::abs(at.signed_distance_m);
    if (nearest.surface >= 0 && clear_m >= nearest.clear_m) continue;
    nearest = {at, static_cast<int>(i), clear_m, nearest.is_sure};
  }
  return nearest;
}

/// Each time by as much as is free, until hardly anything is.
Vec3 stopped_on_line(const World& world, const Vec3& spot_W, const Vec3& up_W, double from_m, double radius_m,
                     double hardly_m, Looks& looks) noexcept {
  constexpr int most_searches = 40;
  double up_m = std::max(0.0, from_m);
  for (int i = 0; i < most_searches && up_m > 0; ++i) {
    const Vec3 place_W = spot_W + up_m * up_W;
    const NearestSurface nearest = nearest_surface(world, place_W, Normals::facet, radius_m + up_m, looks);
    const double free_m = nearest.clear_m - radius_m;
    if (!nearest.is_sure || free_m < hardly_m) break;
    up_m = std::max(0.0, up_m - free_m);
  }
  return spot_W + up_m * up_W;
}

}  // namespace fingerpad
