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

/// Calls `visit(corners, triangle)` for each triangle of a part that is within reach, from `next` on. False
/// where the looks were spent before the end.
/// @param reach_m, sieve  of no matter where the looks have no end: that search is the plain one
template <class Visit>
bool ProxySight::each_within_reach(int surface, const Vec3& at_P, double reach_m, std::size_t& next,
                                   const PacketSieve* sieve, Visit visit) noexcept {
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
    return tree.each_within(at_P, world_.clearance_m() + reach_m, next, looks_, sieve, pass_on, &passing);
  tree.each_within(at_P, world_.clearance_m() + reach_m_, pass_on, &passing);
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
  const double reach_m = std::min(reach_m_, reach_of(way.way_P.norm()));
  return each_within_reach(
      surface, way.from_P, reach_m, round.next, &asked, [&](const TriangleCorners& corners, int triangle) {
        looks_.spend(LookCosts::fetched_cleared);
        if (before.hide(corners)) return;
        if (!looks_.is_unlimited() && round.worst.is_cleared_by_facet(world_, way, corners)) return;
        looks_.spend(LookCosts::told);
        const TriangleApproach a = approach_triangle(corners, way.from_P);
        const long before_it = round.worst.looks;
        round.worst.offer_triangle(world_, way, corners, triangle, {a.at.point, a.towards, a.distance_m});
        looks_.spend(round.worst.looks - before_it);
      });
}

/// Looks for the wall that the way by `z` breaches most. False where the looks were spent before the end.
bool ProxySight::offer_all(const Vec3& z, std::span<const ProxyWall> walls, Round& round) noexcept {
  for (; round.surface < world_.surface_count(); ++round.surface, round.next = 0) {
    if (world_.is_plane(round.surface)) {
      round.worst.offer_plane(world_.plane_wall(round.surface, place_O_), z);
    } else if (!offer_part(round.surface, z, walls, round)) {
      return false;
    }
  }
  return true;
}

bool ProxySight::is_free(const Vec3& z, std::span<const ProxyWall> walls) noexcept {
  Round round;
  round.worst.slack_m = -world_.tolerance_m();
  return offer_all(z, walls, round) && !round.worst.wall;
}

/// Looks for the share of the way by `z` to the first touch. False where the looks were spent before the end.
bool ProxySight::sweep_all(const Vec3& z, Round& round) noexcept {
  for (; round.surface < world_.surface_count(); ++round.surface, round.next = 0) {
    const int i = round.surface;
    double& share = round.free_share;
    if (world_.is_plane(i)) {
      const ProxyWall wall = world_.plane_wall(i, place_O_);
      const double along = wall.normal.dot(z);
      if (along < wall.least_m)
        share = std::min(share, along < 0 ? std::max(0.0, wall.least_m / along) : 0.0);
      continue;
    }
    const PartWay way(world_, i, world_.in_part(i, place_O_), z);
    const bool is_whole = each_within_reach(
        i, way.from_P, reach_m_, round.next, nullptr, [&](const TriangleCorners& corners, int) {
          const TriangleSweep sweep =
              sweep_past_triangle(corners, way.from_P, way.to_P, world_.clearance_m(), world_.tolerance_m());
          if (sweep.blocked) share = std::min(share, sweep.reached);
          looks_.spend(LookCosts::sweep + LookCosts::told + LookCosts::sweep_step * sweep.steps);
        });
    if (!is_whole) return false;
  }
  return true;
}

/// Dual active-set method: the wall that blocks the way most is added until none blocks it. All walls have
/// the start in front of them, so the way to the projection onto them crosses nothing, whenever it is
/// stopped. Where the looks are spent within, it waits in `making_` for the next tick's.
ProxyStep ProxySight::step_towards(const Vec3& goal_O, double most_m, double bent_m) noexcept {
  begin_step(goal_O, most_m, bent_m);
  return go_on_with_step();
}

/// The same to be made at once or not at all.
/// @param first  a wall to begin with, seen from the place looked around from
ProxyStep ProxySight::step_beside(const ProxyWall& first, const Vec3& goal_O) noexcept {
  begin_step(goal_O, reach_m_, 0);
  making_.walls[making_.count++] = first;
  const ProxyStep step = go_on_with_step();
  drop_step();
  return step;
}

void ProxySight::begin_step(const Vec3& goal_O, double most_m, double bent_m) noexcept {
  Making& m = making_;
  m.is_underway = m.is_amid_round = false;
  m.goal = goal_O - place_O_;
  m.step = {};
  m.step.goal_O = goal_O;
  m.most_m = most_m;
  m.bent_m = bent_m;
  m.has_let_go = false;
  m.pass = 0;
  m.count = 0;
  // What the projection leaves behind a wall by rounding must not count as a breach.
  const double rounding_m =
      ProxyLimits::rounding * m.goal.cwiseAbs().maxCoeff() + world_.plane_rounding_m(place_O_);
  m.slack_m = world_.slack_m() + rounding_m;
  m.breach_m = world_.tolerance_m() + ProxyLimits::breach_roundings * rounding_m;
}

/// The projection onto the walls found so far, as far as it may go. False where they leave nothing.
bool ProxySight::project() noexcept {
  Making& m = making_;
  looks_.spend(LookCosts::projection);
  const ProxyProjection p = project_onto_walls(m.goal, std::span(m.walls.data(), m.count), m.slack_m);
  if (!p.found) return false;
  m.step.wall_count = p.active_count;
  m.step.share_m = p.share_m;
  m.count = static_cast<std::size_t>(p.active_count);
  // The active ones are named in rising order.
  for (std::size_t k = 0; k < m.count; ++k)
    m.step.walls[k] = m.walls[k] = m.walls[static_cast<std::size_t>(p.active[k])];
  const double length_m = p.z.norm();
  m.step.truncated = length_m > m.most_m;
  m.step.z = m.step.truncated ? Vec3(p.z * (m.most_m / length_m)) : p.z;
  return true;
}

/// Where that is free, and no farther than was asked for.
void ProxySight::go_on_along_bend() noexcept {
  Making& m = making_;
  if (!(m.bent_m > 0) || m.step.truncated || m.step.wall_count == 0) return;
  looks_.spend(LookCosts::told * m.step.wall_count);
  const Vec3 on = way_along_bend(world_, place_O_, m.step);
  const double on_m = on.norm(), room_m = std::min(m.bent_m, m.most_m) - m.step.z.norm();
  if (!(on_m > 0 && room_m > 0)) return;
  const Vec3 z = m.step.z + std::min(1.0, room_m / on_m) * on;
  if (!((z - m.goal).squaredNorm() < m.goal.squaredNorm())) return;  // no nearer than where it began
  Round round;
  round.worst.slack_m = -m.breach_m;
  if (!offer_all(z, m.step.held_by(), round) || round.worst.wall) return;
  m.step.z = z;
  m.step.bent = on_m <= room_m;
}

/// A wall stands for how the straight way to the goal meets its triangle. Where another wall turns the way
/// off, the ball may never come there: both together would hold it in thin air, for ever. So where a step
/// leads nowhere, walls whose triangles the ball is far from are looked for anew, once, beside those that
/// it is not; where that leads nowhere either, all hold as before. False where there is nothing to let go.
bool ProxySight::let_go_of_far_walls() noexcept {
  Making& m = making_;
  if (m.has_let_go || m.count < 2 || m.step.z.norm() > world_.tolerance_m()) return false;
  looks_.spend(LookCosts::told * static_cast<long>(m.count));
  std::size_t touched = 0;
  for (std::size_t k = 0; k < m.count; ++k) {
    if (!world_.is_far_from(m.walls[k], place_O_)) m.walls[touched++] = m.walls[k];
  }
  if (touched == 0 || touched == m.count) return false;
  m.held = m.step;
  m.count = touched;
  return m.has_let_go = m.is_underway = true;
}

ProxyStep ProxySight::go_on_with_step() noexcept {
  Making& m = making_;
  m.is_underway = true;
  for (; m.pass < ProxyLimits::most_passes; ++m.pass) {
    if (!m.is_amid_round) {
      m.round = {};
      m.round.worst.slack_m = -m.breach_m;
      if (!project()) {
        m.is_underway = false;
        m.step.stuck = true;
        m.step.z.setZero();
        return m.step;
      }
    }
    m.is_amid_round = !offer_all(m.step.z, m.step.held_by(), m.round);
    if (m.is_amid_round) break;
    m.is_underway = m.round.worst.wall.has_value();
    if (!m.is_underway) {
      if (let_go_of_far_walls()) continue;
      if (m.has_let_go && m.step.z.norm() <= world_.tolerance_m()) m.step = m.held;
      go_on_along_bend();
      return m.step;
    }
    m.walls[m.count++] = *m.round.worst.wall;
  }
  if (m.pass == ProxyLimits::most_passes) {
    if (!m.is_amid_round) m.round = {};
    m.is_amid_round = !sweep_all(m.step.z, m.round);
    m.is_underway = m.is_amid_round;
    m.step.stuck = true;
    if (!m.is_underway) m.step.z *= m.round.free_share;
  }
  if (!m.is_underway) return m.step;
  ProxyStep so_far = m.step;
  so_far.z.setZero();
  so_far.stuck = so_far.broken_off = true;
  if (so_far.wall_count == 0 && m.round.worst.wall) {
    // Whatever else blocks, this does.
    so_far.wall_count = 1;
    so_far.walls[0] = *m.round.worst.wall;
    so_far.share_m[0] = so_far.walls[0].lack_m(m.goal);
  }
  return so_far;
}

}  // namespace fingerpad
