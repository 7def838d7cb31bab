#include "contact/proxy_report.hpp"

#include <algorithm>

#include "contact/shown_push.hpp"
#include "contact/surface_point.hpp"
#include "contact/turn.hpp"

namespace fingerpad {
namespace {

/// The turn from the walls' normals to the holds' shaded ones: the mean, each weighted with its share.
/// @pre something is touched: they have shares
Vec3 turn_of_holds(const HoldingWalls& held, const ProxyContact& contact) noexcept {
  Vec3 turn = Vec3::Zero();
  double share_m = 0;
  for (std::size_t k = 0; k < held.held_by().size(); ++k) {
    turn += held.share_m[k] * turn_between(held.walls[k].normal, contact.holds[k].normal_W);
    share_m += held.share_m[k];
  }
  return turn / share_m;
}

/// Greatest first; std::stable_sort would allocate.
void sort_by_share(ProxyContact& contact) noexcept {
  for (std::size_t k = 1; k < static_cast<std::size_t>(contact.hold_count); ++k) {
    for (std::size_t i = k; i > 0 && contact.holds[i].share_m > contact.holds[i - 1].share_m; --i)
      std::swap(contact.holds[i], contact.holds[i - 1]);
  }
}

/// Whether one of the walls that are known holds the finger back.
bool is_held_back(const ProxyState& state) noexcept {
  const auto walls = state.hold.held_by();
  return std::any_of(walls.begin(), walls.end(), [&state](const ProxyWall& wall) {
    return wall.lack_m(state.goal_O - state.hold.from_O) > 0;
  });
}

void tell_holds(const ProxyWorld& world, const HoldingWalls& held, ProxyState& state) noexcept {
  for (std::size_t k = 0; k < held.held_by().size(); ++k)
    state.contact.holds[k] = hold_at(world, held.walls[k], held.share_m[k], state.place_O);
}

/// The push is towards a ball there, and what touches is the ball's point farthest along it.
void tell_direction(const ProxyWorld& world, const Vec3& place_O, const Vec3& direction,
                    ProxyContact& contact) noexcept {
  contact.direction_W = direction;
  contact.point_W = place_O + world.p_WO() - world.radius_m() * direction;
}

/// The proxy has not come to rest: on its way it pushes as far as it still has to go, by the holds of before
/// where no wall is in its way.
void report_underway(const ProxyWorld& world, ProxyState& state) noexcept {
  ProxyContact& contact = state.contact;
  const ProxyStep& hold = state.hold;
  const int hold_count = hold.wall_count > 0 ? hold.wall_count : contact.hold_count;
  tell_holds(world, hold, state);
  const Vec3 push = state.place_O - state.goal_O;
  const double length_m = push.norm();
  contact.depth_m = std::max(0.0, length_m - world.skin_m());
  contact.hold_count = contact.depth_m > 0 ? hold_count : 0;
  if (!contact.touching()) return;
  contact.settled = false;
  tell_direction(world, state.place_O, push / length_m, contact);
  show_push(world, contact.direction_W, state);
}

/// The normal of a wall as Normals says at a point of its triangle.
Vec3 shaded_W(const ProxyWorld& world, const ProxyWall& wall, const TrianglePoint& at) noexcept {
  if (!world.is_shaded()) return wall.normal;
  const PlacedSurface& surface = world.surface(wall.surface);
  const Vec3 normal_P = world.turned_into_part(wall.surface, wall.normal);
  const double side = side_of(surface.tree->part().facet_normals.col(wall.triangle), normal_P);
  return world.turned_from_part(
      wall.surface, side * shaded_normal(*surface.tree, wall.triangle, at, world.normals(), side * normal_P));
}

}  // namespace

std::optional<HoldingWalls> held_without_skin(const ProxyWorld& world, const ProxyStep& hold,
                                              const Vec3& goal_O) noexcept {
  const Vec3 goal = goal_O - hold.from_O;
  // Without its skin the ball's walls stand nearer by that.
  HoldingWalls held = hold;
  for (ProxyWall& wall : held.walls) wall.least_m -= world.skin_m();
  if (held.wall_count == 1) return held_by_one(world, held.walls[0], held.walls[0].lack_m(goal));
  const double slack_m = world.slack_m() + world.plane_rounding_m(hold.from_O, goal_O);
  return held.project(goal, std::nullopt, slack_m) ? std::optional(held) : std::nullopt;
}

ContactHold hold_at(const ProxyWorld& world, const ProxyWall& wall, double share_m,
                    const Vec3& place_O) noexcept {
  if (wall.triangle < 0) {
    const Vec3 point =
        place_O + (world.plane_wall(wall.surface, place_O).least_m - world.clearance_m()) * wall.normal;
    return {wall.surface, wall.triangle, point + world.p_WO(), wall.normal, share_m};
  }
  const TrianglePoint& at = world.approach(wall.surface, wall.triangle, place_O).at;
  return hold_on_facet(world, wall, share_m, world.from_part(wall.surface, at.point), at);
}

ContactHold hold_on_facet(const ProxyWorld& world, const ProxyWall& wall, double share_m, const Vec3& point_O,
                          const TrianglePoint& at) noexcept {
  return {wall.surface, wall.triangle, point_O + world.p_WO(), shaded_W(world, wall, at), share_m};
}

void report(const ProxyWorld& world, ProxyState& state) noexcept {
  const ProxyStep& hold = state.hold;
  // Where the ball stays behind for want of looks, nothing may be in the way at all.
  const bool waits_freely = state.contact.broken_off && !is_held_back(state);
  if (!state.contact.settled && !waits_freely) return report_underway(world, state);
  state.contact.hold_count = 0;
  if (!state.contact.settled || hold.wall_count == 0) return;
  const std::optional<HoldingWalls> held = held_without_skin(world, hold, state.goal_O);
  if (!held) return report_underway(world, state);
  tell_holds(world, *held, state);
  report_held(world, *held, state);
}

void report_held(const ProxyWorld& world, const HoldingWalls& held, ProxyState& state) noexcept {
  ProxyContact& contact = state.contact;
  Vec3 push = Vec3::Zero();
  for (std::size_t k = 0; k < held.held_by().size(); ++k) push += held.share_m[k] * held.walls[k].normal;
  const bool is_single = held.wall_count == 1;
  contact.settled = true;
  contact.depth_m = is_single ? held.share_m[0] : push.norm();
  contact.hold_count = contact.depth_m > 0 ? held.wall_count : 0;
  if (!contact.touching()) return;
  if (is_single) {
    contact.direction_W = held.walls[0].normal;
    contact.point_W = contact.holds[0].point_W;
    return show_push(world, contact.holds[0].normal_W, state);
  }
  tell_direction(world, state.goal_O + push, push / contact.depth_m, contact);
  const Vec3& direction = contact.direction_W;
  show_push(world, world.is_shaded() ? turned(direction, turn_of_holds(held, contact)) : direction, state);
  sort_by_share(contact);
}

}  // namespace fingerpad
