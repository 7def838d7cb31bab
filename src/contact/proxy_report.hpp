#pragma once

#include "contact/proxy_state.hpp"
#include "contact/proxy_world.hpp"

namespace fingerpad {

// What the proxy tells of itself: the walls that hold it, and the way from the finger to it. Each function
// fills the contact of a state whose place and hold are those of the tick's end. All are noexcept and
// allocate nothing.
//
// Shaded normals: each wall that holds the proxy shades its own normal, which turns it by an angle that the
// facets meeting there span. The normal shown for all of them together is the way from the finger to the
// proxy turned by the mean of these turns, each weighted with its wall's share. So it stays within the
// greatest of the walls' own angles of the way, however sharp the corner (a sum of shaded normals, in which
// large shares nearly cancel, does not), and a wall whose share vanishes has no say any more.

/// The proxy rests, or is still on its way: looks for what holds it, and reports.
void report(const ProxyWorld& world, ProxyState& state) noexcept;
/// These walls hold the proxy; their contact.holds are filled, in the same order.
/// @param held  of the ball without its skin
void report_held(const ProxyWorld& world, const HoldingWalls& held, ProxyState& state) noexcept;

/// Whether one wall holds the ball without its skin, and by how much: what project_onto_walls comes to.
/// @param depth_m  how far the finger is behind that ball's wall
inline HoldingWalls held_by_one(const ProxyWorld& world, const ProxyWall& wall, double depth_m) noexcept {
  HoldingWalls held;
  held.wall_count = depth_m > world.slack_m() ? 1 : 0;
  held.walls[0] = wall;
  held.share_m[0] = depth_m;
  return held;
}
/// Which of a step's walls, which are the ball's with its skin, hold the ball without it, and by how much;
/// nothing where rounding leaves these nothing in common.
std::optional<HoldingWalls> held_without_skin(const ProxyWorld& world, const ProxyStep& hold,
                                              const Vec3& goal_O) noexcept;

/// What holds the proxy where the place under it is looked for.
ContactHold hold_at(const ProxyWorld& world, const ProxyWall& wall, double share_m,
                    const Vec3& place_O) noexcept;
/// What a facet's wall holds the proxy by, at a place on the facet.
/// @param point_O  that place
/// @param at       its weights of the facet's corners, and on which feature it is
ContactHold hold_on_facet(const ProxyWorld& world, const ProxyWall& wall, double share_m, const Vec3& point_O,
                          const TrianglePoint& at) noexcept;

}  // namespace fingerpad
