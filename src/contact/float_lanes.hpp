#pragma once

#include <array>
#include <cmath>

#include "contact/triangle_packet.hpp"

// A packet's lanes as the compiler's vectors. For sources that are compiled for several instruction sets, and
// for these alone.

// Vectors of eight floats wider than the plain instruction set has are split by the compiler; they never
// cross a call that is not inlined, so how they would be passed does not matter.
#pragma GCC diagnostic ignored "-Wpsabi"

#define FINGERPAD_INLINED [[gnu::always_inline]] inline

namespace fingerpad::float_lanes {

using EightFloats [[gnu::vector_size(sizeof(float) * packet_width)]] = float;
using EightBits [[gnu::vector_size(sizeof(int) * packet_width)]] = int;

FINGERPAD_INLINED void load(EightFloats& v, const TrianglePacket::Lanes& lanes) noexcept {
  v = *reinterpret_cast<const EightFloats*>(lanes.data());
}

FINGERPAD_INLINED unsigned to_mask(const EightBits& all_or_nothing) noexcept {
#if defined(__SSE__)
  using Four [[gnu::vector_size(16), gnu::may_alias]] = float;
  const Four* half = reinterpret_cast<const Four*>(&all_or_nothing);
  return static_cast<unsigned>(__builtin_ia32_movmskps(half[0])) |
         static_cast<unsigned>(__builtin_ia32_movmskps(half[1])) << 4;
#else
  unsigned mask = 0;
  for (int i = 0; i < packet_width; ++i) mask |= static_cast<unsigned>(all_or_nothing[i] & 1) << i;
  return mask;
#endif
}

FINGERPAD_INLINED void take_roots(EightFloats& v) noexcept {
#if defined(__SSE__)
  // By shuffles, that it stays in registers: a whole vector is slow to read where its halves were written.
  using Four [[gnu::vector_size(16)]] = float;
  const Four low = __builtin_ia32_sqrtps(__builtin_shufflevector(v, v, 0, 1, 2, 3)),
             high = __builtin_ia32_sqrtps(__builtin_shufflevector(v, v, 4, 5, 6, 7));
  v = __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
#else
  for (int i = 0; i < packet_width; ++i) v[i] = std::sqrt(v[i]);
#endif
}

/// A vector in the lanes' rough frames.
struct InFrames {
  EightFloats x, y, z;
};

FINGERPAD_INLINED void dot(EightFloats& product, const EightFloats* v,
                           const std::array<TrianglePacket::Lanes, 3>& axis) noexcept {
  EightFloats a, b, c;
  load(a, axis[0]), load(b, axis[1]), load(c, axis[2]);
  product = v[0] * a + v[1] * b + v[2] * c;
}

/// @param v  in the packet's frame: its x, y and z
FINGERPAD_INLINED void turn(InFrames& turned, const TrianglePacket& p, const EightFloats* v) noexcept {
  dot(turned.x, v, p.x_axis), dot(turned.y, v, p.y_axis), dot(turned.z, v, p.z_axis);
}

/// Of each lane's triangle one of its halves.
struct HalfLanes {
  EightFloats width, normal_x, normal_y, hypotenuse;
};

FINGERPAD_INLINED void take_halves(HalfLanes& half, const TrianglePacket& p,
                                   const EightBits& is_left) noexcept {
  EightFloats right, left;
  load(right, p.half[0].width), load(left, p.half[1].width);
  half.width = is_left ? left : right;
  load(right, p.half[0].normal_x), load(left, p.half[1].normal_x);
  half.normal_x = is_left ? left : right;
  load(right, p.half[0].normal_y), load(left, p.half[1].normal_y);
  half.normal_y = is_left ? left : right;
  load(right, p.half[0].hypotenuse), load(left, p.half[1].hypotenuse);
  half.hypotenuse = is_left ? left : right;
}

}  // namespace fingerpad::float_lanes
