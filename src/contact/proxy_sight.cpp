#include "contact/proxy_sight.hpp"

#include <cmath>

#include "contact/facet_fan.hpp"
#include "contact/proxy_limits.hpp"

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

ProxyStep ProxySight::step(const Vec3& place_O, const Vec3& goal_O, double most_m) noexcept {
  const Vec3 goal = goal_O - place_O;
  place_O_ = place_O;
  reach_m_ = reach_of(std::min(goal.norm(), most_m));
  return step_towards(goal, nullptr);
}

ProxyStep ProxySight::step_over(const Vec3& edge_O, const Vec3& goal_O, const ProxyWall& first,
                                double) noexcept {
  const Vec3 goal = goal_O - edge_O;
  place_O_ = edge_O;
  reach_m_ = reach_of(goal.norm());
  return step_towards(goal, &first);
}

bool ProxySight::is_way_free(const Vec3& place_O, const Vec3& over, const Vec3&,
                             const ProxyWall& here) noexcept {
  place_O_ = place_O;
  reach_m_ = reach_of(over.norm());
  return !worst_wall(over, std::span(&here, 1), world_.tolerance_m());
}

std::optional<WallPair> ProxySight::nearer_neighbour(const ProxyState& s) noexcept {
  if (!world_.is_shaded()) return std::nullopt;
  const auto wall_O = facet_that_holds(world_, s);
  if (!wall_O) return std::nullopt;
  FacetFan fan;
  fan.gather(world_, *wall_O);
  const ProxyWall* nearest_O = fan.nearest_to(world_, *wall_O, s.goal_O);
  if (nearest_O == nullptr) return std::nullopt;
  return WallPair{wall_O->seen_from(s.place_O), nearest_O->seen_from(s.place_O)};
}

void ProxySight::offer_part(int surface, const Vec3& z, std::span<const ProxyWall> walls,
                            WorstWall& worst) noexcept {
  const PartWay way(world_, surface, world_.in_part(surface, place_O_), z);
  const PartWalls before(world_, surface, walls, way.from_P);
  each_triangle_within(*world_.surface(surface).tree, way.from_P, world_.clearance_m() + reach_m_,
                       [&](const TriangleCorners& corners, int triangle) {
                         if (before.hide(corners)) return;
                         const TriangleApproach a = approach_triangle(corners, way.from_P);
                         worst.offer_triangle(world_, way, corners, triangle, a.towards,
                                              a.distance_m - world_.clearance_m());
                       });
}

std::optional<ProxyWall> ProxySight::worst_wall(const Vec3& z, std::span<const ProxyWall> walls,
                                                double breach_m) noexcept {
  WorstWall worst{std::nullopt, -breach_m};
  for (int i = 0; i < world_.surface_count(); ++i) {
    if (world_.is_plane(i)) {
      worst.offer_plane(world_.plane_wall(i, place_O_), z);
    } else {
      offer_part(i, z, walls, worst);
    }
  }
  return worst.wall;
}

/// The share of the way by `z` to the first touch.
double ProxySight::free_share(const Vec3& z) noexcept {
  double share = 1;
  for (int i = 0; i < world_.surface_count(); ++i) {
    if (world_.is_plane(i)) {
      const ProxyWall wall = world_.plane_wall(i, place_O_);
      const double along = wall.normal.dot(z);
      if (along < wall.least_m)
        share = std::min(share, along < 0 ? std::max(0.0, wall.least_m / along) : 0.0);
      continue;
    }
    const PartWay way(world_, i, world_.in_part(i, place_O_), z);
    each_triangle_within(*world_.surface(i).tree, way.from_P, world_.clearance_m() + reach_m_,
                         [&](const TriangleCorners& corners, int) {
                           const TriangleSweep sweep = sweep_past_triangle(
                               corners, way.from_P, way.to_P, world_.clearance_m(), world_.tolerance_m());
                           if (sweep.blocked) share = std::min(share, sweep.reached);
                         });
  }
  return share;
}

/// Dual active-set method: the wall that blocks the way most is added until none blocks it. All walls have
/// the start in front of them, so the way to the projection onto them crosses nothing, whenever it is
/// stopped.
/// @param goal   relative to the place looked around from
/// @param first  a wall to begin with, or none
ProxyStep ProxySight::step_towards(const Vec3& goal, const ProxyWall* first) noexcept {
  ProxyStep step;
  std::array<ProxyWall, 4> walls;
  std::size_t count = 0;
  if (first != nullptr) walls[count++] = *first;
  // What the projection leaves behind a wall by rounding must not count as a breach.
  const double rounding_m =
      ProxyLimits::rounding * goal.cwiseAbs().maxCoeff() + world_.plane_rounding_m(place_O_);
  const double slack_m = world_.slack_m() + rounding_m, breach_m = world_.tolerance_m() + 2 * rounding_m;
  for (int pass = 0; pass < ProxyLimits::most_passes; ++pass) {
    const ProxyProjection p = project_onto_walls(goal, std::span(walls.data(), count), slack_m);
    if (!p.found) {
      step.stuck = true;
      step.z.setZero();
      return step;
    }
    step.wall_count = p.active_count;
    step.share_m = p.share_m;
    count = static_cast<std::size_t>(p.active_count);
    // The active ones are named in rising order.
    for (std::size_t k = 0; k < count; ++k)
      step.walls[k] = walls[k] = walls[static_cast<std::size_t>(p.active[k])];
    const double length_m = p.z.norm();
    step.truncated = length_m > reach_m_;
    step.z = step.truncated ? Vec3(p.z * (reach_m_ / length_m)) : p.z;
    const auto worst = worst_wall(step.z, step.held_by(), breach_m);
    if (!worst) return step;
    walls[count++] = *worst;
  }
  step.stuck = true;
  step.z *= free_share(step.z);
  return step;
}

}  // namespace fingerpad
