#pragma once

#include <algorithm>
#include <cmath>

#include "contact/triangle_packet.hpp"
#include "contact/triangle_tree.hpp"
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

/// Leaves out those packets of a part of which no triangle can be a worse wall to a ball's way than the worst
/// so far, or stands before the walls that the ball stays in front of anyway.
///
/// A sweep's first tangent bounds how far its wall is breached (TriangleSweep): with f a triangle's foot, q
/// the way's start, w the way and R the clearance, the wall's slack is at least |q - f| - R + w.(q - f)/|q -
/// f|. Where all corners lie within r of a packet's middle m, and D = |q - m| > r, |q - f| is at least D - r,
/// and q - f is turned off q - m by at most asin(r/D), so that the last term is at least
/// w.(q - m)/D cos(asin(r/D)) - |w| r/D.
///
/// Neighbours on a fine smooth surface lie in a flat disc besides. With m now its centre, u a unit
/// vector and h how far the disc reaches beyond m along u, each of them is at least u.(x - m) - h from any x:
/// where that is the clearance at both ends of the way, it is all along. With u from m to the middle of the
/// way this leaves, of a surface that the ball lies on, what is within about a disc's width of where it
/// touches.
class WaySieve {
 public:
  /// @param before  the walls, seen from the way's start
  /// @param worst   may become worse as the sieve is used
  WaySieve(const ProxyWorld& world, const PartWay& way, const PartWalls& before,
           const WorstWall& worst) noexcept
      : way_(way),
        before_(before),
        worst_(worst),
        clearance_m_(world.clearance_m()),
        rounding_m_(world.tolerance_m()),
        way_m_(way.way_P.norm()) {}

  PacketSieve asked() const noexcept {
    return {[](const void* sieve, const PacketDisc& disc, double scaled_m) noexcept {
              return static_cast<const WaySieve*>(sieve)->passes_over(disc, scaled_m);
            },
            [](const void* sieve, const TrianglePacket& packet, double scaled_m) noexcept {
              return static_cast<const WaySieve*>(sieve)->leaves_out(packet, scaled_m);
            },
            this, looks_at_further_walls(before_)};
  }

  /// @param scaled_m  PacketSieve's
  bool passes_over(const PacketDisc& disc, double scaled_m) const noexcept {
    const Vec3 centre_m = scaled_m * Vec3(disc.centre[0], disc.centre[1], disc.centre[2]);
    const Vec3 off = way_.from_P + 0.5 * way_.way_P - centre_m;
    const double distance_m = off.norm();
    const Vec3 out = off / distance_m;
    const double nearer_m = distance_m - 0.5 * std::abs(out.dot(way_.way_P));
    return nearer_m - scaled_m * disc.highest(out) >= clearance_m_ - rounding_m_;
  }

  /// @param scaled_m  PacketSieve's
  bool leaves_out(const TrianglePacket& packet, double scaled_m) const noexcept {
    const Vec3 off = way_.from_P - scaled_m * packet.origin;
    const double distance_m = off.norm(), radius_m = scaled_m * static_cast<double>(packet.radius);
    if (distance_m > radius_m) {
      const double sine = radius_m / distance_m;
      const double slope_m = off.dot(way_.way_P) / distance_m * std::sqrt(1 - sine * sine) - way_m_ * sine;
      if (distance_m - radius_m - clearance_m_ + slope_m > worst_.slack_m + rounding_m_) return true;
    }
    return std::any_of(before_.walls().begin(), before_.walls().end(), [&](const PartWalls::Wall& wall) {
      return scaled_m * (wall.normal_P.dot(packet.origin) + packet.highest(wall.normal_P)) <= wall.offset_m;
    });
  }

 private:
  const PartWay& way_;
  const PartWalls& before_;
  const WorstWall& worst_;
  double clearance_m_, rounding_m_, way_m_;
};

}  // namespace fingerpad
