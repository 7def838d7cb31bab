#include "contact/proxy_start.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "contact/proxy_limits.hpp"
#include "contact/surface_point.hpp"
#include "contact/worst_wall.hpp"

namespace fingerpad {
namespace {

/// The nearest place that keeps the clearance from every plane, by the dual active-set method: the plane that
/// is breached most is added until none is.
std::optional<Vec3> out_of_planes(const ProxyWorld& world, const Vec3& goal_O) noexcept {
  HoldingWalls walls;
  Vec3 place_O = goal_O;
  for (int pass = 0; pass < ProxyLimits::most_passes; ++pass) {
    const double slack_m = world.plane_rounding_m(place_O, goal_O);
    WorstWall worst{std::nullopt, -ProxyLimits::breach_roundings * slack_m};
    for (const int i : world.planes()) worst.offer_plane(world.plane_wall(i, place_O), Vec3::Zero());
    if (!worst.wall) return place_O;
    const auto z = walls.project(Vec3::Zero(), world.plane_wall(worst.wall->surface, goal_O), slack_m);
    if (!z) return std::nullopt;
    place_O = goal_O + *z;
  }
  return std::nullopt;
}

}  // namespace

ProxyStart::End ProxyStart::go_on(const ProxyWorld& world, const Vec3& goal_O, Looks& looks) noexcept {
  if (!(world.extent_m() > 0)) {
    const auto out_O = out_of_planes(world, goal_O);
    place_O_ = out_O.value_or(goal_O);
    return out_O ? End::placed : End::no_place;
  }
  const bool takes_long = is_underway_ && ++ticks_ >= ProxyLimits::patient_ticks;
  // Where there was none, there likely is none yet: what looks for it takes little of a tick.
  if (has_failed_ && (goal_O - goal_O_).norm() > world.clearance_m()) is_underway_ = false;
  const double price =
      LookCosts::of_start * (has_failed_ || takes_long ? ProxyLimits::less_after_no_place : 1);
  Looks few(std::max(1L, std::lround(static_cast<double>(looks.left()) / price)));
  const End end = push_on(world, goal_O, few);
  looks.spend(std::lround(LookCosts::of_start * static_cast<double>(few.spent())));
  return end;
}

/// From the goal, or on from where it was broken off: the pushes go outwards, and where they lead into
/// another surface, out of that again.
ProxyStart::End ProxyStart::push_on(const ProxyWorld& world, const Vec3& goal_O, Looks& looks) noexcept {
  if (!is_underway_) {
    const bool has_failed = has_failed_;
    *this = {};
    has_failed_ = has_failed;
    place_O_ = goal_O_ = goal_O;
    look_anew(world);
  }
  for (; pushes_ < ProxyLimits::most_pushes; ++pushes_) {
    is_underway_ = looks.are_spent() || !look_at_all(world, looks);
    if (is_underway_) return End::broken_off;
    if (!(worst_.least_m > world.tolerance_m())) {
      has_failed_ = false;
      return End::placed;
    }
    place_O_ += worst_.least_m * worst_.normal;
    if (is_going_round()) break;
    if ((pushes_ & (pushes_ - 1)) == 0) passed_O_ = place_O_;
    look_anew(world);
  }
  has_failed_ = true;
  return End::no_place;
}

/// Whether it is back where it was, between walls that are nearer to each other than the ball is wide: if all
/// pushes led on by as little, that would be next to nothing of what it lacks.
bool ProxyStart::is_going_round() const noexcept {
  return (place_O_ - passed_O_).norm() * ProxyLimits::most_pushes < ProxyLimits::little_way * worst_.least_m;
}

void ProxyStart::look_anew(const ProxyWorld& world) noexcept {
  part_ = 0;
  worst_.least_m = world.tolerance_m();
}

/// Looks for the surface that the place is nearest to, or deepest in. False where it was broken off.
bool ProxyStart::look_at_all(const ProxyWorld& world, Looks& looks) noexcept {
  for (; part_ < world.parts().size(); ++part_) {
    if (!look_at_part(world, world.parts()[part_], looks)) return false;
    look_ = {};
  }
  for (const int plane : world.planes()) note(world.plane_wall(plane, place_O_));
  return true;
}

void ProxyStart::note(const ProxyWall& wall) noexcept {
  if (wall.least_m > worst_.least_m) worst_ = wall;
}

/// False where it was broken off.
bool ProxyStart::look_at_part(const ProxyWorld& world, int surface, Looks& looks) noexcept {
  const TriangleTree& tree = *world.surface(surface).tree;
  const Vec3 q_P = world.in_part(surface, place_O_);
  if ((q_P.cwiseAbs() - tree.part().half_extent).maxCoeff() > world.clearance_m()) return true;
  // What lies deep inside is pushed out, however far it is to the surface.
  const auto find_closest = [&] {
    const double reach_m = look_.is_deep ? std::numeric_limits<double>::infinity() : world.clearance_m();
    return tree.closest(q_P, reach_m, look_.closest, looks);
  };
  std::optional<ClosestTriangle> closest = find_closest();
  if (closest && closest->triangle < 0 && !look_.is_deep) {
    // Of what is not near, all that counts is whether the place is inside, which takes far fewer looks to
    // tell than what is closest.
    const auto inside = tree.encloses(q_P, look_.winding, looks);
    if (!inside) return false;
    if (!*inside) return true;
    look_.is_deep = true;
    look_.closest.next = 0;  // from the triangle that it began near
    closest = find_closest();
  }
  if (!closest) return false;
  const SurfacePoint near =
      surface_point_at(tree, *closest, q_P + tree.part().centre_P, Normals::facet, world.clearance_m());
  if (near.triangle < 0) return true;
  const bool is_behind = near.signed_distance_m < 0;
  const auto inside = is_behind ? tree.encloses(q_P, look_.winding, looks) : false;
  if (!inside) return false;
  // Behind a sheet that encloses nothing the way out is away from it, as it is in front.
  const double side = is_behind && !*inside ? -1 : 1;
  note({world.surface(surface).R_WP * (side * near.normal_P),
        world.clearance_m() - side * near.signed_distance_m, surface, near.triangle});
  return true;
}

}  // namespace fingerpad
