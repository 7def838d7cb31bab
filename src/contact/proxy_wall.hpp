#pragma once

#include <array>
#include <optional>
#include <span>

#include "base/types.hpp"

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

/// Up to three walls as one: what their normals alone fix of every projection onto all of them.
class WallsTogether {
 public:
  WallsTogether() = default;
  /// @param normals  unit; the first `count` are read
  WallsTogether(const std::array<Vec3, 3>& normals, int count) noexcept;

  /// Whether the walls fix the multipliers: no two of them are parallel to 1e-8, no three of them flat.
  bool fix_shares() const noexcept { return fix_shares_; }

  /// The multipliers [m] that put a point onto every wall.
  /// @param lack_m  how far it is behind each
  /// @pre fix_shares()
  std::array<double, 3> shares_m(const std::array<double, 3>& lack_m) const noexcept {
    if (count_ < 2) return lack_m;
    if (count_ == 2) {
      // The 2 x 2 system, written so that nearly equal normals cancel nothing but the missing lengths.
      const double apart_m = (lack_m[0] - turn_ * lack_m[1]) * per_sine2_;
      return {apart_m + turn_ * lack_m[1] * common_, turn_ * (lack_m[0] * common_ - apart_m), 0};
    }
    const Vec3 shift_m = lack_m[0] * dual_[0] + lack_m[1] * dual_[1] + lack_m[2] * dual_[2];
    return {shift_m.dot(dual_[0]), shift_m.dot(dual_[1]), shift_m.dot(dual_[2])};
  }

 private:
  int count_ = 0;
  bool fix_shares_ = true;
  double turn_ = 1, common_ = 0, per_sine2_ = 0;  // of two: the sign of the cosine, 1/(1 + |cosine|), ...
  std::array<Vec3, 3> dual_;                      // of three: 1 along its own normal, 0 along the others
};

/// The walls that hold a point which is as close to a goal as they let it.
struct HoldingWalls {
  int wall_count = 0;
  std::array<ProxyWall, 3> walls;
  std::array<double, 3> share_m{};  ///< multiplier of each, >= 0

  std::span<const ProxyWall> held_by() const noexcept {
    return {walls.data(), static_cast<std::size_t>(wall_count)};
  }
  /// A pass of the dual active-set method: with one wall more, if there is one, keeps those that the point
  /// closest to the goal lies on. Returns that point; nothing, and changes nothing, where there is none.
  std::optional<Vec3> project(const Vec3& goal, const std::optional<ProxyWall>& more,
                              double tolerance_m) noexcept;
};

/// The point of an intersection of half spaces that lies closest to a goal, and the walls that it lies on:
/// z - goal is the sum of their shares times their normals.
struct ProxyProjection : HoldingWalls {
  bool found = false;
  Vec3 z = Vec3::Zero();
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

}  // namespace fingerpad
