#include "view/touch_doubts.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/number_text.hpp"
#include "part/part.hpp"
#include "view/surface_hit.hpp"

namespace fingerpad {

std::string too_deep_words(const World& world, const TickRecord& row) {
  const auto surface = static_cast<std::size_t>(std::max(row.surface, 0));
  if (row.phase == Phase::free || row.surface < 0 || surface >= world.surfaces.size()) return {};
  const Surface& touched = world.surfaces[surface];
  if (touched.is_plane() || !touched.tree || !(row.depth_m > 0)) return {};
  constexpr double below_share = 1e-6;  // of the part: a line from the surface itself would meet it there
  const double below_m = below_share * touched.part->size_m();
  const Vec3 from_W = row.contact_W - below_m * row.normal_W,
             to_W = row.contact_W - row.depth_m * row.normal_W;
  if (!(row.depth_m > below_m)) return {};
  // How thick it is there is not told: beside an edge the line leaves by the side.
  // From inside it comes out. A line that begins outside of a hole's rim, whose walls hold the finger
  // together, goes in first.
  const auto hit = line_hit(touched, from_W, to_W);
  if (!hit || !(hit->normal_W.dot(row.normal_W) < 0)) return {};
  return fmt::format("{} mm deep, through the part: press less, or stiffen it",
                     rounded_text(1e3 * row.depth_m, 2));
}

bool is_too_large_for(const World& world, const Vec3& spot_W, const Vec3& normal_W, double radius_m) {
  // A finger in a hollow of coarse facets, or at the foot of a shallow slope, reaches a little into others.
  constexpr double clear_share = 0.75;
  if (!(radius_m > 0)) return false;
  const Vec3 centre_W = spot_W + radius_m * normal_W;
  return std::ranges::any_of(world.surfaces, [&](const Surface& surface) {
    if (!surface.is_plane() && !surface.tree) return false;
    const WorldPoint near = nearest_point(surface, centre_W, Normals::facet, -1, radius_m);
    return near.found && near.signed_distance_m < clear_share * radius_m;
  });
}

}  // namespace fingerpad
