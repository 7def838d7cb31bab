#pragma once

#include <cstddef>
#include <limits>

#include "contact/looks.hpp"
#include "contact/proxy_world.hpp"
#include "contact/triangle_tree.hpp"

namespace fingerpad {

/// Where a ball that appears at `goal_O` may stand: there if nothing comes nearer than the clearance, else
/// the nearest surface point outwards, moved on where another surface is in the way. Inside of a part is
/// where the nearest feature's pseudonormal says so and the winding number about the point is above one half:
/// not merely behind an open sheet, and not outside a shell that is wound inside out. No place where none was
/// found within a bounded search (a slot narrower than the ball). Among planes alone: the nearest place that
/// is clear of all of them.
class ProxyStart {
 public:
  enum class End { placed, no_place, broken_off };

  /// A start that was broken off is gone on with, from the goal that it began with. One that takes long goes
  /// on with a share of the looks, and so does the next after one that found no place, until it finds one;
  /// that begins anew where the finger has gone on by more than the clearance.
  /// @param goal_O  finite
  /// noexcept, allocates nothing. O(triangles) where the goal is behind a surface and the looks have no end.
  End go_on(const ProxyWorld& world, const Vec3& goal_O, Looks& looks) noexcept;
  const Vec3& place_O() const noexcept { return place_O_; }

 private:
  /// How far the look at one part has come.
  struct PartLook {
    bool is_deep = false;  ///< it is farther than the clearance, and the place inside of it
    ClosestWalk closest;
    WindingWalk winding;
  };

  End push_on(const ProxyWorld& world, const Vec3& goal_O, Looks& looks) noexcept;
  void look_anew(const ProxyWorld& world) noexcept;
  bool look_at_all(const ProxyWorld& world, Looks& looks) noexcept;
  bool look_at_part(const ProxyWorld& world, int surface, Looks& looks) noexcept;
  void note(const ProxyWall& wall) noexcept;
  bool is_going_round() const noexcept;

  bool is_underway_ = false;
  bool has_failed_ = false;  // the last one to end found no place
  int ticks_ = 0;            // that it was gone on with in
  Vec3 goal_O_ = Vec3::Zero();
  Vec3 place_O_ = Vec3::Zero();
  int pushes_ = 0;
  Vec3 passed_O_ = Vec3::Constant(std::numeric_limits<double>::infinity());  // a place that it came by
  std::size_t part_ = 0;  // of the world's parts, to be looked at next ...
  PartLook look_;         // ... and how far that has come
  ProxyWall worst_;  // of those looked at so far, the one that the place is farthest behind; seen from it
};

}  // namespace fingerpad
