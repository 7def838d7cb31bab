#pragma once

#include <cmath>
#include <cstddef>

#include "touch/world.hpp"

namespace fingerpad {

/// What of a world is nearest to a place.
struct NearestSurface {
  WorldPoint at;
  int surface = -1;  ///< -1: nothing within reach
  double clear_m =
      0;  ///< how far away; less than 0 inside of what has an inside. The reach where nothing is.
  bool is_sure = true;  ///< else the looks did not suffice, and something nearer may be there
};

/// Of all surfaces that can be touched the nearest; of two that are as near the first.
/// @param find        of a surface's number: the point of it that is nearest
/// @param has_inside  of a surface's number: behind it is inside; else one is as free there as before it
/// noexcept, allocates nothing, if these are and do.
template <typename Find, typename HasInside>
NearestSurface nearest_of(const World& world, double reach_m, const Find& find,
                          const HasInside& has_inside) noexcept {
  NearestSurface nearest;
  nearest.clear_m = reach_m;
  for (std::size_t i = 0; i < world.surfaces.size(); ++i) {
    const Surface& surface = world.surfaces[i];
    if (surface.part && !surface.tree) continue;
    const WorldPoint at = find(i);
    if (!at.found) continue;
    const bool is_sided = surface.is_plane() || has_inside(i);
    const double clear_m = is_sided ? at.signed_distance_m : std::abs(at.signed_distance_m);
    if (nearest.surface >= 0 && clear_m >= nearest.clear_m) continue;
    nearest.at = at;
    nearest.surface = static_cast<int>(i);
    nearest.clear_m = clear_m;
  }
  return nearest;
}

}  // namespace fingerpad
