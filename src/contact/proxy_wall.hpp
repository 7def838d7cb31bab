#pragma once

#include <array>
#include <optional>
#include <span>

#include "contact/walls_together.hpp"

namespace fingerpad {

/// A half space that the ball's centre must stay in: normal . z >= least_m.
///
/// The axes are the world's. z counts from an origin that each wall's user names: a wall "seen from a place"
/// counts from there, so that its numbers are as small as a step; one whose name ends in _O from the origin
/// of frame O (ProxyWorld).
struct ProxyWall {
  Vec3 normal = Vec3::UnitZ();  ///< unit, out of the surface
  double least_m = 0;
  int surface = -1;
  int triangle = -1;  ///< -1: of a plane

  /// How far a place is behind the wall; negative in front of it.
  double lack_m(const Vec3& place) const noexcept { return least_m - normal.dot(place); }
  /// The same half space, counted from `origin` on.
  ProxyWall seen_from(const Vec3& origin) const noexcept {
    return {normal, lack_m(origin), surface, triangle};
  }
};

/// 1 where a wall's normal lies on the outer side of its facet, -1 where the wall holds from behind.
inline double side_of(const Vec3& outer_normal, const Vec3& wall_normal) noexcept {
  return outer_normal.dot(wall_normal) < 0 ? -1 : 1;
}

/// The point of an intersection of half spaces that lies closest to a goal.
struct ProxyProjection {
  bool found = false;
  Vec3 z = Vec3::Zero();
  int active_count = 0;
  std::array<int, 3> active{};      ///< which walls the point lies on
  std::array<double, 3> share_m{};  ///< multipliers, >= 0: z - goal is the sum of share times normal
};

/// The place on both walls' planes that lies closest to `near`; nothing where they are parallel to 1e-8.
std::optional<Vec3> on_both_walls(const Vec3& near, const ProxyWall& a, const ProxyWall& b) noexcept;

/// Projects `goal` onto at most four half spaces by looking at every choice of at most three of them: in
/// three dimensions no more are needed to hold the closest point. A choice with two planes that are parallel
/// to 1e-8 is passed over: one of the two alone gives the same point. Not found where rounding leaves the
/// half spaces nothing in common.
/// @param walls  at most four
/// @param tolerance_m  a point this far behind a wall still counts as in front of it
/// noexcept, O(1), allocates nothing.
ProxyProjection project_onto_walls(const Vec3& goal, std::span<const ProxyWall> walls,
                                   double tolerance_m) noexcept;

/// The walls that hold a point which is as close to a goal as they let it.
struct HoldingWalls {
  int wall_count = 0;
  std::array<ProxyWall, 3> walls;
  std::array<double, 3> share_m{};  ///< multiplier of each

  std::span<const ProxyWall> held_by() const noexcept {
    return {walls.data(), static_cast<std::size_t>(wall_count)};
  }
  /// A pass of the dual active-set method: with one wall more, if there is one, keeps those that the point
  /// closest to the goal lies on. Returns that point; nothing, and changes nothing, where there is none.
  std::optional<Vec3> project(const Vec3& goal, const std::optional<ProxyWall>& more,
                              double tolerance_m) noexcept;
};

}  // namespace fingerpad
