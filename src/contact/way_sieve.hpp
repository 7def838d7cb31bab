#pragma once

#include <algorithm>
#include <cmath>

#include "contact/triangle_packet.hpp"
#include "contact/triangle_tree.hpp"
#include "contact/way_filter.hpp"
#include "contact/worst_wall.hpp"

namespace fingerpad {

/// Whether a triangle's own plane shows that it is no worse a wall than the worst: then it need not be told
/// how far it is.
/// @param facet  how the way stands before that plane
inline bool is_cleared_by(const FacetSide& facet, const WorstWall& worst, double tolerance_m) noexcept {
  return facet.side != 0 && (facet.slack_m >= -tolerance_m || facet.slack_m > worst.slack_m);
}
inline bool is_cleared_by_facet(const ProxyWorld& world, const PartWay& way, const TriangleCorners& corners,
                                const WorstWall& worst) noexcept {
  const double tolerance_m = world.tolerance_m();
  return is_cleared_by(facet_side(corners, way.from_P, way.to_P, world.clearance_m(), tolerance_m), worst,
                       tolerance_m);
}

/// What it costs to hold something against all walls, more than against one.
inline long looks_at_further_walls(const PartWalls& before) noexcept {
  return LookCosts::further_wall * std::max(0L, static_cast<long>(before.walls().size()) - 1);
}

/// Leaves out those triangles of a part that cannot be a worse wall to a ball's way than the worst so far, or
/// stand behind walls that the ball stays in front of anyway.
///
/// Neighbours on a fine smooth surface lie in a flat disc. With m its centre, u a unit vector and h how far
/// the disc reaches beyond m along u, each of them is at least u.(x - m) - h from any x: where that is the
/// clearance at both ends of the way, it is all along. With u from m to the middle of the way this leaves, of
/// a surface that the ball lies on, what is within about a disc's width of where it touches.
///
/// A packet's triangles are held against the way all at once, in floats (WayFilter). Slivers have no rough
/// frame, but what bounds a packet's triangles bounds them together: a sweep's first tangent tells how far
/// its wall is breached at most (TriangleSweep). With f a triangle's foot, q the way's start, w the way and R
/// the clearance, the wall's slack is at least |q - f| - R + w.(q - f)/|q - f|. Where all corners lie within
/// r of a packet's middle m, and D = |q - m| > r, |q - f| is at least D - r, and q - f is turned off q - m by
/// at most asin(r/D), so that the last term is at least w.(q - m)/D cos(asin(r/D)) - |w| r/D.
class WaySieve {
 public:
  /// @param before  the walls, seen from the way's start
  /// @param worst   may become worse as the sieve is used
  /// @param scale   of the packets' lengths, of one metre
  WaySieve(const ProxyWorld& world, const PartWay& way, const PartWalls& before, const WorstWall& worst,
           double scale) noexcept
      : before_(before),
        worst_(worst),
        scale_(scale),
        start_(scale * way.from_P),
        way_(scale * way.way_P),
        middle_(start_ + 0.5 * way_),
        length_(way_.norm()),
        clearance_(scale * world.clearance_m()),
        tolerance_(scale * world.tolerance_m()) {}

  PacketSieve asked() const noexcept {
    return {[](const void* sieve, const PacketDisc& disc) noexcept {
              return static_cast<const WaySieve*>(sieve)->passes_over(disc);
            },
            [](const void* sieve, const TrianglePacket& packet) noexcept {
              return static_cast<const WaySieve*>(sieve)->lanes_left(packet);
            },
            this, looks_at_further_walls(before_)};
  }

  bool passes_over(const PacketDisc& disc) const noexcept {
    const Vec3 off = middle_ - Vec3(disc.centre[0], disc.centre[1], disc.centre[2]);
    const double distance = off.norm();
    return distance * (distance - clearance_ + tolerance_) - 0.5 * std::abs(off.dot(way_)) >
           disc.highest(off);
  }

  /// The lanes of the triangles that may matter.
  unsigned lanes_left(const TrianglePacket& packet) const noexcept;

 private:
  RoughWay seen_from(const TrianglePacket& packet) const noexcept;
  bool clears_slivers(const TrianglePacket& packet) const noexcept;

  const PartWalls& before_;
  const WorstWall& worst_;
  double scale_;
  Vec3 start_, way_, middle_;  // all lengths scaled
  double length_, clearance_, tolerance_;
};

}  // namespace fingerpad
