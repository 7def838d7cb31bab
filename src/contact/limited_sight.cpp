#include "contact/limited_sight.hpp"

#include "contact/proxy_limits.hpp"
#include "contact/way_sieve.hpp"

namespace fingerpad {

bool LimitedSight::offer_part(int surface, const Vec3& z, std::span<const ProxyWall> walls,
                              LookRound& round) noexcept {
  if (looks_.is_unlimited()) return ProxySight::offer_part(surface, z, walls, round);
  const PartWay way(world_, surface, world_.in_part(surface, at_.place_O), z);
  const PartWalls before(world_, surface, walls, way.from_P);
  const TriangleTree& tree = *world_.surface(surface).tree;
  const WaySieve sieve(world_, way, before, round.worst, tree.packets_scale());
  const PacketSieve asked = sieve.asked();
  auto offer = [&](int triangle) {
    looks_.spend(LookCosts::fetched_cleared + looks_at_further_walls(before));
    const TriangleCorners corners = corners_of(tree.part(), triangle);
    if (before.hide(corners) || is_cleared_by_facet(world_, way, corners, round.worst)) return;
    looks_.spend(LookCosts::told);
    const FirstApproach first(approach_triangle(corners, way.from_P));
    const long before_it = round.worst.looks;
    round.worst.offer_triangle(world_, way, corners, triangle, first);
    looks_.spend(round.worst.looks - before_it);
  };
  const double reach_m = world_.clearance_m() * (1 + ProxyLimits::reach_rounding);
  return tree.each_beside(way.from_P, way.way_P, reach_m, round.next, looks_, &asked,
                          call_with_triangle<decltype(offer)>, &offer);
}

}  // namespace fingerpad
