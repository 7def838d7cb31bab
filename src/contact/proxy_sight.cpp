#include "contact/proxy_sight.hpp"

#include <cmath>

#include "contact/bent_walls.hpp"
#include "contact/facet_fan.hpp"
#include "contact/proxy_limits.hpp"
#include "contact/way_sieve.hpp"

namespace fingerpad {
namespace {

/// A reach that a way of this length does not end beyond, whatever rounding does.
double reach_of(double way_m) noexcept {
  return way_m * (1 + ProxyLimits::reach_rounding);
}

/// The wall in O, where a single facet holds the proxy and its place lies over the facet's face.
std::optional<ProxyWall> facet_that_holds(const ProxyWorld& world, const ProxyState& s) noexcept {
  const ProxyWall& wall = s.hold.walls[0];
  if (s.hold.wall_count != 1 || wall.triangle < 0 || s.hold.stuck || !s.contact.settled) return std::nullopt;
  const ProxyWall wall_O = wall.seen_from(-s.hold_place_O);
  if (std::abs(wall_O.lack_m(s.place_O)) > world.touching_m()) return std::nullopt;
  if (world.approach(wall.surface, wall.triangle, s.place_O).at.feature != Feature::face) return std::nullopt;
  return wall_O;
}

}  // namespace

/// Calls `visit(corners, triangle)` for each triangle of a part that the ball may come upon on a way, from
/// `next` on. False where the looks were spent before the end.
/// @param sieve  of no matter where the looks have no end: that search is the plain one
template <class Visit>
bool ProxySight::each_beside_way(const PartWay& way, std::size_t& next, const PacketSieve* sieve,
                                 Visit visit) noexcept {
  const int surface = way.surface;
  const TriangleTree& tree = *world_.surface(surface).tree;
  struct Passing {
    const Part* part;
    Visit* visit;
  } passing{&tree.part(), &visit};
  const auto pass_on = [](void* context, int triangle) {
    const Passing& p = *static_cast<Passing*>(context);
    (*p.visit)(corners_of(*p.part, triangle), triangle);
  };
  if (!looks_.is_unlimited())
    return tree.each_beside(way.from_P, way.way_P, reach_of(world_.clearance_m()), next, looks_, sieve,
                            pass_on, &passing);
  tree.each_within(way.from_P, world_.clearance_m() + reach_m_, pass_on, &passing);
  return true;
}

ProxyStep ProxySight::step(const Vec3& place_O, const Vec3& goal_O, const StepTerms& terms) noexcept {
  if (is_amid_step()) return go_on_with_step();
  place_O_ = place_O;
  reach_m_ = reach_of(std::min((goal_O - place_O).norm(), terms.most_m));
  return step_towards(goal_O, reach_m_, terms.bent_m);
}

ProxyStep ProxySight::step_over(const Vec3& edge_O, const Vec3& goal_O, const ProxyWall& first,
                                double) noexcept {
  place_O_ = edge_O;
  reach_m_ = reach_of((goal_O - edge_O).norm());
  return step_beside(first, goal_O);
}

bool ProxySight::is_way_free(const Vec3& place_O, const Vec3& over, const Vec3&,
                             const ProxyWall& here) noexcept {
  place_O_ = place_O;
  reach_m_ = reach_of(over.norm());
  return is_free(over, std::span(&here, 1));
}

std::optional<WallPair> ProxySight::nearer_neighbour(const ProxyState& s) noexcept {
  if (!world_.is_shaded()) return std::nullopt;
  const auto wall_O = facet_that_holds(world_, s);
  if (!wall_O) return std::nullopt;
  FacetFan fan;
  fan.gather(world_, *wall_O);
  looks_.spend(LookCosts::fetched * fan.looks());
  const ProxyWall* nearest_O = fan.nearest_to(world_, *wall_O, s.goal_O);
  if (nearest_O == nullptr) return std::nullopt;
  return WallPair{wall_O->seen_from(s.place_O), nearest_O->seen_from(s.place_O)};
}

bool ProxySight::offer_part(int surface, const Vec3& z, std::span<const ProxyWall> walls,
                            Round& round) noexcept {
  const PartWay way(world_, surface, world_.in_part(surface, place_O_), z);
  const PartWalls before(world_, surface, walls, way.from_P);
  const WaySieve sieve(world_, way, before, round.worst);
  const PacketSieve asked = sieve.asked();
  return each_beside_way(way, round.next, &asked, [&](const TriangleCorners& corners, int triangle) {
    looks_.spend(LookCosts::fetched_cleared);
    if (before.hide(corners)) return;
    if (!looks_.is_unlimited() && is_cleared_by_facet(world_, way, corners, round.worst)) return;
    looks_.spend(LookCosts::told);
    const FirstApproach first(approach_triangle(corners, way.from_P));
    const long before_it = round.worst.looks;
    round.worst.offer_triangle(world_, way, corners, triangle, first);
    looks_.spend(round.worst.looks - before_it);
  });
}

bool ProxySight::offer_all(const Vec3& z, std::span<const ProxyWall> walls, Round& round) noexcept {
  for (; round.part < world_.parts().size(); ++round.part, round.next = 0) {
    if (!offer_part(world_.parts()[round.part], z, walls, round)) return false;
  }
  for (const int i : world_.planes()) round.worst.offer_plane(world_.plane_wall(i, place_O_), z);
  return true;
}

bool ProxySight::is_free(const Vec3& z, std::span<const ProxyWall> walls) noexcept {
  Round round;
  round.worst.slack_m = -world_.tolerance_m();
  return offer_all(z, walls, round) && !round.worst.wall;
}

bool ProxySight::sweep_all(const Vec3& z, Round& round) noexcept {
  double& share = round.free_share;
  for (; round.part < world_.parts().size(); ++round.part, round.next = 0) {
    const int i = world_.parts()[round.part];
    const PartWay way(world_, i, world_.in_part(i, place_O_), z);
    const bool is_whole = each_beside_way(way, round.next, nullptr, [&](const TriangleCorners& corners, int) {
      const TriangleSweep sweep =
          sweep_past_triangle(corners, way.from_P, way.to_P, world_.clearance_m(), world_.tolerance_m());
      if (sweep.blocked) share = std::min(share, sweep.reached);
      looks_.spend(LookCosts::sweep + LookCosts::told + LookCosts::sweep_step * sweep.steps);
    });
    if (!is_whole) return false;
  }
  for (const int i : world_.planes()) {
    const ProxyWall wall = world_.plane_wall(i, place_O_);
    const double along = wall.normal.dot(z);
    if (along < wall.least_m) share = std::min(share, along < 0 ? std::max(0.0, wall.least_m / along) : 0.0);
  }
  return true;
}

ProxyStep ProxySight::step_towards(const Vec3& goal_O, double most_m, double bent_m,
                                   std::span<const ProxyWall> first) noexcept {
  making_.begin(*this, goal_O, most_m, bent_m);
  for (const ProxyWall& wall : first) making_.guess(wall);
  return go_on_with_step();
}

/// The same to be made at once or not at all.
/// @param first  a wall to begin with, seen from the place looked around from
ProxyStep ProxySight::step_beside(const ProxyWall& first, const Vec3& goal_O) noexcept {
  making_.begin(*this, goal_O, reach_m_, 0);
  making_.add(first);
  const ProxyStep step = go_on_with_step();
  drop_step();
  return step;
}

}  // namespace fingerpad
