#include "contact/limited_sight.hpp"

#include "contact/proxy_limits.hpp"
#include "contact/way_sieve.hpp"

namespace fingerpad {

/// Calls `visit(corners, triangle)` for each triangle of a part that the ball may come upon on a way, from
/// `next` on. False where the looks were spent before the end.
/// @param sieve  null: no triangle is left out
template <class Visit>
bool LimitedSight::each_beside(const PartWay& way, std::size_t& next, const PacketSieve* sieve,
                               Visit visit) noexcept {
  const TriangleTree& tree = *world_.surface(way.surface).tree;
  auto visit_one = [&](int triangle) { visit(corners_of(tree.part(), triangle), triangle); };
  const double reach_m = world_.clearance_m() * (1 + ProxyLimits::reach_rounding);
  return tree.each_beside(way.from_P, way.way_P, reach_m, next, looks_, sieve,
                          call_with_triangle<decltype(visit_one)>, &visit_one);
}

bool LimitedSight::offer_part(int surface, const Vec3& z, std::span<const ProxyWall> walls,
                              LookRound& round) noexcept {
  if (looks_.is_unlimited()) return ProxySight::offer_part(surface, z, walls, round);
  const PartWay way(world_, surface, world_.in_part(surface, place_O_), z);
  const PartWalls before(world_, surface, walls, way.from_P);
  const WaySieve sieve(world_, way, before, round.worst);
  const PacketSieve asked = sieve.asked();
  return each_beside(way, round.next, &asked, [&](const TriangleCorners& corners, int triangle) {
    looks_.spend(LookCosts::fetched_cleared);
    if (before.hide(corners) || is_cleared_by_facet(world_, way, corners, round.worst)) return;
    looks_.spend(LookCosts::told);
    const FirstApproach first(approach_triangle(corners, way.from_P));
    const long before_it = round.worst.looks;
    round.worst.offer_triangle(world_, way, corners, triangle, first);
    looks_.spend(round.worst.looks - before_it);
  });
}

bool LimitedSight::sweep_part(int surface, const Vec3& z, LookRound& round) noexcept {
  if (looks_.is_unlimited()) return ProxySight::sweep_part(surface, z, round);
  const PartWay way(world_, surface, world_.in_part(surface, place_O_), z);
  return each_beside(way, round.next, nullptr, [&](const TriangleCorners& corners, int) {
    const int steps = round.sweep(world_, way, corners);
    looks_.spend(LookCosts::sweep + LookCosts::told + LookCosts::sweep_step * steps);
  });
}

}  // namespace fingerpad
