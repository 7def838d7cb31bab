#pragma once

#include "contact/triangle_packet.hpp"

namespace fingerpad {

/// Rough squared distances of a packet's triangles from a point.
struct alignas(32) RoughDistances {
  TrianglePacket::Lanes squared;  ///< [scaled^2]; enormous for lanes without a rough frame
};

/// The filter's margin, a multiple of u = 2^-24, half of a float's last place at 1.
///
/// Claim: for a lane with a rough frame let d be the exact distance of q from the triangle and e the square
/// root of its rough squared distance. Then |e - d| <= 32 u (|r| + 2 radius) + 1e-14 (1 + |q|), all scaled,
/// where r = q - origin.
///
/// Proof, with S = |r| + radius, which bounds every distance between q and a point of the triangle:
/// 1. r and the foot f are rounded to float, and so is their difference v: a component is off by at most
///    u (|r_i| + |f_i| + |v_i|), so v by 2 u S.
/// 2. An axis is rounded by u, and its plane known to 1e-9 < 0.02 u (the height is at least 1e-6 of the
///    length); a sum of three products costs 3 u |v|. So a coordinate is off by at most 2 u S + 4.1 u S, and
///    the point (x, y, z) in the frame by sqrt(3) times that, under 11 u S. Distance is 1-Lipschitz: d
///    changes by no more.
/// 3. From there take x, y, z as exact. Turning to the half on the point's side and asking for y < 0 are then
///    exact. In the half let w be its width and l its hypotenuse, at most 2 radius. Below (y < 0),
///    max(x - w, 0) is off by u w + u |x - w|. Above, s = (x - w) n_x + y n_y, the height over the
///    hypotenuse, is off by u w + 4 u |x - w| + 3 u |y|; the place t along it likewise, and t - l by u l + u
///    |t - l| more. |x - w|, |y| and |t - l| are at most S. So s and what t exceeds [0, l] by are off by at
///    most 8 u S + 4 u radius each, their norm by 12 u S + 6 u radius. Inside, s <= 0 and t is in [0, l]: no
///    branch asks for it, so none can be taken wrongly.
/// 4. Squares and two sums: 2 u d at most. Underflow costs d under 1e-20.
/// Together under 25 u S + 6 u radius; what is left of the 32 pays for computing limits in float. The last
/// term is for rounding in double: of the origin and the frame (a few 1e-16), and of the exact distance that
/// the filter decides about (4e-15 of part and point, as the tests of closest_in hold).
inline constexpr float rough_margin = 32 * 0x1p-24f;

/// Puts the rough squared distances of all lanes into `rough` and returns those at most `limit2` as bits.
/// @param r  q - packet.origin, scaled
/// Where lanes are compared with limits that leave room for the margin, no result depends on how this was
/// compiled: whatever passes is decided in double.
using PacketFilter = unsigned (*)(const TrianglePacket& packet, const float* r, float limit2,
                                  RoughDistances& rough) noexcept;

/// Flat discs around packets, side by side: what a packet holds is no farther than `radius` from its centre,
/// and no farther than `thick` from the plane through it that `across` is normal to. Lengths scaled; centres
/// relative to a place near them.
struct alignas(32) PacketDiscs {
  std::array<TrianglePacket::Lanes, 3> centre, across;
  TrianglePacket::Lanes radius, thick;
};

/// The discs' margin, a multiple of u = 2^-24, as rough_margin is the triangles'.
///
/// Claim: let d be the distance of q from anything in a disc, and S no smaller than what |point|, |centre|
/// and the radius add up to. Then the disc passes wherever d <= limit - disc_margin * S and lost2 >=
/// disc_margin * S^2.
///
/// Proof. 1. point and centre are rounded to float, and so is their difference s: off by 2 u S at most.
/// 2. `across` is what the thickness was measured along, exactly, but of length 1 +- 4 u: so is h, the height
///    over the plane, a sum of three products, off by 2 u S + 4 u S and the rounding of that length by 4 u S.
///    The gap across the disc, |h| - thick, is off by 11 u S.
/// 3. |s|^2 - h^2, the square of the way along the plane, is off by 8 u S^2 and 20 u S^2: with `lost2` taken
///    off, it is too small. So is its root but for u S, and the gap along the plane, root - radius, by 2 u S.
/// 4. Both gaps together are too large by 13 u S at most; the squares and the root of the last comparison
///    cost 4 u S more.
inline constexpr float disc_margin = 32 * 0x1p-24f;

/// Which discs of up to eight groups may hold something within `limit` of a point: a byte of bits a group,
/// the first lowest. See disc_margin.
using DiscFilter = std::uint64_t (*)(const PacketDiscs* discs, int groups, const float* point, float limit,
                                     float lost2) noexcept;

/// The fastest filter that this machine can run.
PacketFilter fastest_packet_filter() noexcept;
DiscFilter fastest_disc_filter() noexcept;

/// The filter that every machine can run.
PacketFilter plain_packet_filter() noexcept;
DiscFilter plain_disc_filter() noexcept;

}  // namespace fingerpad
