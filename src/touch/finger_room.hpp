#pragma once

#include "contact/looks.hpp"
#include "touch/world.hpp"

namespace fingerpad {

/// What of a world is nearest to a place.
struct NearestSurface {
  WorldPoint at;
  int surface = -1;     ///< -1: nothing within reach
  double clear_m = 0;   ///< how far away; less than 0 inside of a closed part. The reach where nothing is.
  bool is_sure = true;  ///< else the looks did not suffice, and something nearer may be there
};

/// @param reach_m  look no farther
/// @param looks    that it may cost, and pays for. noexcept, allocates nothing.
NearestSurface nearest_surface(const World& world, const Vec3& p_W, Normals normals, double reach_m,
                               Looks& looks) noexcept;

/// Where a ball is stopped that comes down a line to a spot: a finger on the rim of a hole that it is too
/// large for. The spot itself where nothing stops it. Some forty searches at most; where the looks do not
/// suffice it is stopped higher, clear of everything. noexcept, allocates nothing.
/// @param up_W      from the spot along the line, unit
/// @param from_m    so far up the ball begins, outside of all parts
/// @param hardly_m  so little room is none
Vec3 stopped_on_line(const World& world, const Vec3& spot_W, const Vec3& up_W, double from_m, double radius_m,
                     double hardly_m, Looks& looks) noexcept;

}  // namespace fingerpad
