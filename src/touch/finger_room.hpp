#pragma once

#include <optional>

#include "contact/looks.hpp"
#include "touch/nearest_of.hpp"
#include "touch/world.hpp"

namespace fingerpad {

/// For what is looked for in a tick, or for an event that waits for no frame: some two tenths of a
/// millisecond.
inline constexpr long room_looks = 20000;

/// Nearest to a place. Of parts the closed ones have an inside.
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

/// Where a ball rests on a hole that it is too large for.
struct RimPlace {
  Vec3 centre_W;
  int surface;  ///< that stops it
};

/// The rim on which a ball is stopped that comes down a line, though the line itself may meet nothing. None
/// where the ball gets through, or by what it meets: it gives way by its radius, and goes on. None where the
/// looks do not suffice. noexcept, allocates nothing.
/// @param from_W, to_W  ends of the line, outside of all parts
std::optional<RimPlace> rim_on_line(const World& world, const Vec3& from_W, const Vec3& to_W, double radius_m,
                                    Looks& looks) noexcept;

/// What stops a ball that comes down a line to a spot that is seen, before it is there: bars whose gaps it is
/// too large for. None where nothing does, where the ball slides round it and on to the spot (past one edge,
/// into a slot that is wide enough; near by it where the spot itself has no room, in a corner), or where the
/// looks do not suffice. noexcept, allocates nothing.
/// @param from_W    the line's end, outside of all parts
/// @param normal_W  at the spot, unit, on the side that is seen
std::optional<RimPlace> rim_before(const World& world, const Vec3& from_W, const Vec3& spot_W,
                                   const Vec3& normal_W, double radius_m, Looks& looks) noexcept;

}  // namespace fingerpad
