#pragma once

#include <array>

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
  float worst;                         ///< slack of the worst wall so far, or more
  float margin;                        ///< no distance is off by more, see way_margin
  std::array<Wall, most_walls> walls;  ///< that the ball stays in front of anyway
  std::size_t wall_count;
};

/// The filter's margin, a multiple of u = 2^-24 of S, which is no smaller than what |start|, the way's
/// length, the clearance and twice the packet's radius add up to; see rough_margin for how a rough frame is
/// off.
///
/// Claim: let a triangle with a rough frame be none that the filter names. Then it stands behind one of the
/// walls, or all that a sweep past it finds (sweep_past_triangle) is a slack greater than `worst`.
///
/// Proof. The distance g(s) from the triangle, less the clearance, of the place at a share s of the way is
/// convex. With s* where it first is 0, the sweep's slack is at least h(s*), with h(s) = g(s) + (1 - s)
/// g'(s): what the tangent at s leaves at the way's end. As h'(s) = (1 - s) g''(s) >= 0, each h(s) with s <=
/// s* <= 1 bounds the slack from below; where g has no zero, it is not a wall at all.
/// 1. A place in a lane's frame is off by 11 u S at the start (rough_margin, 2). The way's coordinates are
///    off by 5 u of its length each, a place on it by 24 u S; which place is looked at is free to choose.
/// 2. The vector v from the triangle's closest point to the place changes by no more than the place does.
///    It is made of the same terms as the rough distance (rough_margin, 3), and off by 20 u S more: with
///    m = way_margin S, v is off by less than m, and so is |v|, which g is told from.
/// 3. v/|v| is off by less than 2 m/|v|, and the slope g' = v.way/|v| by less than that times the length,
///    and by 16 u of the length. So h is off by less than e = 2 m + 2 m length/|v|; where |v| is no longer
///    than m, that is more than all that h tells.
/// 4. From s on, g is 0 no sooner than its tangent, the sooner, the smaller g and the steeper g' are taken:
///    less m, and steeper by 2 m length/|v| + m. What rounding does to s itself is far less.
/// 5. In front of the triangle's own plane, by the clearance where the way begins, the slack is no smaller
///    than the plane's at its end (FacetSide). Heights are off by less than m.
/// 6. A corner's height over a wall is a sum of terms that are off by 8 u S together.
inline constexpr float way_margin = 64 * 0x1p-24f;

/// Which lanes may be worse walls to the way than the worst so far, as bits. Lanes without a rough frame
/// mean nothing.
using WayFilter = unsigned (*)(const TrianglePacket& packet, const RoughWay& way) noexcept;

/// The fastest filter that this machine can run, and the one that every machine can: both name the same.
WayFilter fastest_way_filter() noexcept;
WayFilter plain_way_filter() noexcept;

}  // namespace fingerpad
