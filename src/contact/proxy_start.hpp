#pragma once

#include <cstddef>
#include <limits>
#include <optional>

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
  /// How much a place lacks of the clearance, and which way out is.
  struct Lack {
    double lack_m = 0;
    Vec3 outwards_W = Vec3::UnitZ();
  };

  End push_on(const ProxyWorld& world, const Vec3& goal_O, Looks& looks) noexcept;
  bool is_going_round() const noexcept;
  bool find_worst(const ProxyWorld& world, Looks& looks) noexcept;
  bool lack_of_part(const ProxyWorld& world, int part, Looks& looks, Lack& lack) noexcept;
  void note(const Lack& lack) noexcept;

  bool is_underway_ = false;
  bool has_failed_ = false;  // the last one to end found no place
  Vec3 goal_O_ = Vec3::Zero();
  Vec3 place_O_ = Vec3::Zero();
  Vec3 passed_O_ = Vec3::Constant(std::numeric_limits<double>::infinity());  // a place that it came by
  int pushes_ = 0;
  int ticks_ = 0;         // that it was gone on with in
  std::size_t part_ = 0;  // of the world's parts, to be looked at next ...
  bool is_deep_ = false;  // it is farther than the clearance, and the place inside of it
  ClosestWalk closest_;   // how far that has come
  WindingWalk winding_;
  Lack worst_;
  bool lacks_ = false;  // a surface is nearer than the clearance: worst_
};

}  // namespace fingerpad
