#include "contact/proxy_start.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "contact/proxy_limits.hpp"
#include "contact/surface_point.hpp"

namespace fingerpad {
namespace {

/// The nearest place that keeps the clearance from every plane, by the dual active-set method: the plane that
/// is breached most is added until none is.
std::optional<Vec3> out_of_planes(const ProxyWorld& world, const Vec3& goal_O) noexcept {
  ActiveWalls walls;
  Vec3 place_O = goal_O;
  for (int pass = 0; pass < ProxyLimits::most_passes; ++pass) {
    const double slack_m = world.plane_rounding_m(place_O, goal_O);
    double worst_m = ProxyLimits::breach_roundings * slack_m;
    int worst = -1;
    for (const int i : world.planes()) {
      const double lack_m = world.plane_wall(i, place_O).least_m;
      if (!(lack_m > worst_m)) continue;
      worst_m = lack_m;
      worst = i;
    }
    if (worst < 0) return place_O;
    walls.add(world.plane_wall(worst, goal_O));
    const ProxyProjection p = walls.project(Vec3::Zero(), slack_m);
    if (!p.found) return std::nullopt;
    place_O = goal_O + p.z;
  }
  return std::nullopt;
}

}  // namespace

/// False where it was broken off.
bool ProxyStart::lack_of_part(const ProxyWorld& world, int part_number, Looks& looks, Lack& lack) noexcept {
  const PlacedSurface& s = world.surface(part_number);
  const Part& part = s.tree->part();
  const Vec3 q_P = world.in_part(part_number, place_O_);
  lack = {-1, Vec3::UnitZ()};
  if ((q_P.cwiseAbs() - part.half_extent).maxCoeff() > world.clearance_m()) return true;
  // Of what is not near, all that counts is whether the place is inside, which takes far fewer looks to tell
  // than what is closest.
  std::optional<ClosestTriangle> closest;
  if (!is_deep_) {
    closest = s.tree->closest(q_P, world.clearance_m(), closest_, looks);
    if (!closest) return false;
    if (closest->triangle < 0) {
      const auto inside = s.tree->encloses(q_P, winding_, looks);
      if (!inside) return false;
      if (!*inside) return true;
      is_deep_ = true;
      closest_.next = 0;  // from the triangle that it began near
    }
  }
  // What lies deep inside is pushed out, however far it is to the surface.
  if (is_deep_) closest = s.tree->closest(q_P, std::numeric_limits<double>::infinity(), closest_, looks);
  if (!closest) return false;
  const SurfacePoint near =
      surface_point_at(*s.tree, *closest, q_P + part.centre_P, Normals::facet, world.clearance_m());
  if (near.triangle < 0) return true;
  const bool behind = near.signed_distance_m < 0;
  const auto inside = behind ? s.tree->encloses(q_P, winding_, looks) : false;
  if (!inside) return false;
  if (behind && !*inside) {
    lack = {world.clearance_m() + near.signed_distance_m, s.R_WP * (-near.normal_P)};
  } else {
    lack = {world.clearance_m() - near.signed_distance_m, s.R_WP * near.normal_P};
  }
  return true;
}

/// Keeps what is nearest, where that is nearer than the clearance.
void ProxyStart::note(const Lack& lack) noexcept {
  if (!(lack.lack_m > worst_.lack_m)) return;
  worst_ = lack;
  lacks_ = true;
}

/// Looks for what is nearest in the place's way. False where it was broken off.
bool ProxyStart::find_worst(const ProxyWorld& world, Looks& looks) noexcept {
  for (; part_ < world.parts().size(); ++part_) {
    Lack lack;
    if (!lack_of_part(world, world.parts()[part_], looks, lack)) return false;
    is_deep_ = false;
    closest_ = {};
    winding_ = {};
    note(lack);
  }
  for (const int plane : world.planes()) {
    const ProxyWall wall = world.plane_wall(plane, place_O_);
    note({wall.least_m, wall.normal});
  }
  return true;
}

ProxyStart::End ProxyStart::go_on(const ProxyWorld& world, const Vec3& goal_O, Looks& looks) noexcept {
  if (!(world.extent_m() > 0)) {
    const auto out_O = out_of_planes(world, goal_O);
    place_O_ = out_O.value_or(goal_O);
    return out_O ? End::placed : End::no_place;
  }
  const bool takes_long = is_underway_ && ++ticks_ >= ProxyLimits::patient_ticks;
  if (!has_failed_ && !takes_long) return push_on(world, goal_O, looks);
  // Where there was none, there likely is none yet: what looks for it takes little of a tick.
  if (has_failed_ && (goal_O - goal_O_).norm() > world.clearance_m()) is_underway_ = false;
  Looks few(std::max(1L, looks.left() / ProxyLimits::less_after_no_place));
  const End end = push_on(world, goal_O, few);
  looks.spend(few.spent());
  return end;
}

/// From the goal, or on from where it was broken off.
ProxyStart::End ProxyStart::push_on(const ProxyWorld& world, const Vec3& goal_O, Looks& looks) noexcept {
  if (!is_underway_) {
    const bool has_failed = has_failed_;
    *this = {};
    has_failed_ = has_failed;
    place_O_ = goal_O_ = goal_O;
    worst_.lack_m = world.tolerance_m();
  }
  // The pushes go outwards, and where they lead into another surface, out of that again.
  for (; pushes_ < ProxyLimits::most_pushes; ++pushes_) {
    is_underway_ = looks.are_spent() || !find_worst(world, looks);
    if (is_underway_) return End::broken_off;
    if (!lacks_) {
      has_failed_ = false;
      return End::placed;
    }
    place_O_ += worst_.lack_m * worst_.outwards_W;
    if (is_going_round()) break;
    if ((pushes_ & (pushes_ - 1)) == 0) passed_O_ = place_O_;
    part_ = 0;
    worst_ = {world.tolerance_m(), Vec3::UnitZ()};
    lacks_ = false;
  }
  has_failed_ = true;
  return End::no_place;
}

/// Whether it is back where it was, between walls that are nearer to each other than the ball is wide: if all
/// pushes led on by as little, that would be next to nothing of what it lacks.
bool ProxyStart::is_going_round() const noexcept {
  return (place_O_ - passed_O_).norm() * ProxyLimits::most_pushes < ProxyLimits::little_way * worst_.lack_m;
}

}  // namespace fingerpad
