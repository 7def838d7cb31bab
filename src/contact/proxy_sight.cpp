#include "contact/proxy_sight.hpp"

#include <algorithm>
#include <cmath>

#include "contact/facet_fan.hpp"
#include "contact/proxy_limits.hpp"

namespace fingerpad {
namespace {

/// Where a single facet holds the proxy from over its face, its wall in O.
std::optional<ProxyWall> facet_that_holds(const ProxyWorld& world, const ProxyState& s) noexcept {
  const ProxyWall* wall = s.one_triangles_wall();
  if (wall == nullptr) return std::nullopt;
  const ProxyWall wall_O = wall->seen_from(-s.hold.from_O);
  if (std::abs(wall_O.lack_m(s.place_O)) > world.touching_m()) return std::nullopt;
  if (world.approach(wall_O.surface, wall_O.triangle, s.place_O).at.feature != Feature::face)
    return std::nullopt;
  return wall_O;
}

}  // namespace

/// A way of this length does not end beyond the reach, whatever rounding does.
void ProxySight::look_from(const Vec3& place_O, double way_m) noexcept {
  at_ = {place_O, way_m * (1 + ProxyLimits::reach_rounding)};
}

ProxyStep ProxySight::step(const ProxyState& s, const StepTerms& terms) noexcept {
  if (!making_.is_underway()) {
    look_from(s.place_O, std::min((s.goal_O - s.place_O).norm(), terms.most_m));
    making_.begin(*this, s.goal_O, at_.reach_m, terms.bent_m);
  }
  return making_.go_on(*this);
}

std::optional<ProxyStep> ProxySight::step_over(const WayOver& way) noexcept {
  look_from(way.place_O, way.edge.norm());
  if (!is_free(way.edge, way.walls.here)) return no_way();
  const Vec3 edge_O = way.place_O + way.edge;
  look_from(edge_O, (way.goal_O - edge_O).norm());
  return step_from_edge(way);
}

std::optional<ProxyStep> ProxySight::no_way() const noexcept {
  return looks_.are_spent() ? std::optional(broken_off_step()) : std::nullopt;
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
                            LookRound& round) noexcept {
  const PartWay way(world_, surface, world_.in_part(surface, at_.place_O), z);
  const PartWalls before(world_, surface, walls, way.from_P);
  const Part& part = world_.part(surface);
  auto offer = [&](int triangle) {
    const TriangleCorners corners = corners_of(part, triangle);
    if (before.hide(corners)) return;
    round.worst.offer_triangle(world_, way, corners, triangle,
                               FirstApproach(approach_triangle(corners, way.from_P)));
  };
  world_.surface(surface).tree->each_within(way.from_P, world_.clearance_m() + at_.reach_m,
                                            call_with_triangle<decltype(offer)>, &offer);
  return true;
}

bool ProxySight::offer_all(const Vec3& z, std::span<const ProxyWall> walls, LookRound& round) noexcept {
  for (; round.part < world_.parts().size(); ++round.part, round.next = 0) {
    if (!offer_part(world_.parts()[round.part], z, walls, round)) return false;
  }
  for (const int i : world_.planes()) round.worst.offer_plane(world_.plane_wall(i, at_.place_O), z);
  return true;
}

bool ProxySight::is_free(const Vec3& z, const ProxyWall& wall) noexcept {
  LookRound round(world_.tolerance_m());
  return offer_all(z, std::span(&wall, 1), round) && !round.worst.wall;
}

/// From the edge looked around from; to be made at once or not at all.
ProxyStep ProxySight::step_from_edge(const WayOver& way) noexcept {
  making_.begin(*this, way.goal_O, at_.reach_m, 0);
  making_.add(way.walls.there.seen_from(way.edge));
  const ProxyStep step = making_.go_on(*this);
  making_.drop();
  return step;
}

}  // namespace fingerpad
