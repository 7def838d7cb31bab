#pragma once

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
  using Four [[gnu::vector_size(16)]] = float;
  Four* half = reinterpret_cast<Four*>(&v);
  half[0] = __builtin_ia32_sqrtps(half[0]);
  half[1] = __builtin_ia32_sqrtps(half[1]);
#else
  for (int i = 0; i < packet_width; ++i) v[i] = std::sqrt(v[i]);
#endif
}

}  // namespace fingerpad::float_lanes
