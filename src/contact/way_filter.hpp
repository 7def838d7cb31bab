#pragma once

#include <array>
#include <cstddef>

#include "contact/triangle_packet.hpp"

namespace fingerpad {

/// A ball's way past a packet's triangles, in floats. Lengths scaled (see PackedPart), places relative to the
/// packet's origin.
struct RoughWay {
  static constexpr std::size_t most_walls = 3;
  struct Wall {
    std::array<float, 3> normal;
    float offset;  ///< what lies no farther along the normal surely stands behind it
  };

  std::array<float, 3> start, way;
  float length;                        ///< of the way
  float clearance;                     ///< what the ball keeps from every triangle
  float worst;                         ///< slack of the worst wall so far
  float margin;                        ///< no distance is off by more, see way_margin
  std::array<Wall, most_walls> walls;  ///< that the ball stays in front of anyway
  std::size_t wall_count;
};

/// The filter's margin is at least so many times S, which is no smaller than what |start|, the way's length,
/// the clearance and twice the packet's radius add up to, and so many of the tolerances at which a sweep
/// ends. With u = 2^-24; see rough_margin for how a rough frame is off.
///
/// Claim: let a triangle with a rough frame be none that the filter names. Then it stands behind one of the
/// walls, or all that a sweep past it finds (sweep_past_triangle) is a slack greater than `worst`.
///
/// Proof. The distance g(s) from the triangle, less the clearance, of the place at a share s of the way is
/// convex. What its tangent at s leaves at the way's end is h(s) = g(s) + (1 - s) g'(s); as
/// h'(s) = (1 - s) g''(s) >= 0, it grows with s. A sweep goes from s = 0 to each tangent's zero in turn,
/// until g is no more than a tolerance, and its slack is h there, or more: so h(s) bounds it from below at
/// every s up to that place. Where a tangent has no zero before the end, there is no wall at all.
/// 1. A place in a lane's frame is off by 11 u S at the start (rough_margin, 2), by 9 u S for the way and by
///    4 u S for their sum: 24 u S. Which s is looked at is free to choose.
/// 2. The vector v from the triangle's closest point to the place changes by no more than the place does. It
///    is made of the same terms as the rough distance (rough_margin, 3), and off by 20 u S more. The floats
///    of `worst`, clearance, length and margin lose u S each. That is less than 50 u S together: with m the
///    margin, v, and |v| with it, is off by less than m.
/// 3. v/|v| is off by less than 2 m/|v| (directions of two vectors differ by no more than twice what the
///    vectors do, over the longer one's length), and the slope g' = v.way/|v| by less than that times the
///    way's length, and by 16 u of the length. So h is off by less than e = 2 m + 2 m length/|v|.
/// 4. The filter goes from s to no farther than where a tangent that begins m lower and falls by
///    2 m length/|v| + m more is 0. There g is more than a tolerance still, and the sweep is not yet at its
///    end: each place of the filter is before the sweep's of the same number, since both begin at 0 and a
///    tangent's zero moves on with the place it is taken at. Where g(0) is no more than m, s stays 0, and
///    h(0) is the sweep's own first tangent.
/// 5. In front of the triangle's own plane, by the clearance where the way begins, the slack is no smaller
///    than the plane's at its end (FacetSide, which has a side here: where there is a rough frame, rounding
///    moves no corner off the plane by a tolerance). Heights are off by less than m.
/// 6. A corner's height over a wall is a sum of terms that are off by less than 16 u S together.
inline constexpr float way_margin = 64 * 0x1p-24f;
inline constexpr double way_margin_tolerances = 4;

/// Which lanes may be worse walls to the way than the worst so far, as bits. Lanes without a rough frame
/// mean nothing. What a tick may still look at depends on how many are named: so each filter makes the same
/// sums in the same order, and none may contract a product and a sum into one (FMA).
using WayFilter = unsigned (*)(const TrianglePacket& packet, const RoughWay& way) noexcept;

/// The fastest filter that this machine can run, and the one that every machine can: both name the same.
WayFilter fastest_way_filter() noexcept;
WayFilter plain_way_filter() noexcept;

}  // namespace fingerpad
