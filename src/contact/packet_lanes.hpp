#pragma once

#include "contact/triangle_packet.hpp"

// A packet's lanes as vectors of eight floats. Wider than what the plain instruction set has they are split
// by the compiler; they never cross a call that is not inlined, so how they would be passed does not matter.
#pragma GCC diagnostic ignored "-Wpsabi"

#define FINGERPAD_INLINED [[gnu::always_inline]] inline

namespace fingerpad {

using Floats [[gnu::vector_size(sizeof(float) * packet_width)]] = float;
using Bits [[gnu::vector_size(sizeof(int) * packet_width)]] = int;

FINGERPAD_INLINED void load(Floats& v, const TrianglePacket::Lanes& lanes) noexcept {
  v = *reinterpret_cast<const Floats*>(lanes.data());
}

FINGERPAD_INLINED void store(TrianglePacket::Lanes& lanes, const Floats& v) noexcept {
  *reinterpret_cast<Floats*>(lanes.data()) = v;
}

FINGERPAD_INLINED unsigned to_mask(const Bits& all_or_nothing) noexcept {
#if defined(__SSE__)
  using Four [[gnu::vector_size(16)]] = float;
  const Four* half = reinterpret_cast<const Four*>(&all_or_nothing);
  return static_cast<unsigned>(__builtin_ia32_movmskps(half[0])) |
         static_cast<unsigned>(__builtin_ia32_movmskps(half[1])) << 4;
#else
  unsigned mask = 0;
  for (int i = 0; i < packet_width; ++i) mask |= static_cast<unsigned>(all_or_nothing[i] & 1) << i;
  return mask;
#endif
}

/// A point in the lanes' frames: in the half on its side, x counted away from the altitude.
struct InFrames {
  Floats x, y, z;
  Bits left;

  /// @param r  the point less the packet's origin: one for all lanes, or one for each
  template <class Coordinate>
  FINGERPAD_INLINED InFrames(const TrianglePacket& p, const Coordinate* r) noexcept {
    Floats v[3], a, b, c;
    for (int i = 0; i < 3; ++i) {
      load(a, p.foot[i]);
      v[i] = r[i] - a;
    }
    load(a, p.x_axis[0]), load(b, p.x_axis[1]), load(c, p.x_axis[2]);
    x = v[0] * a + v[1] * b + v[2] * c;
    load(a, p.y_axis[0]), load(b, p.y_axis[1]), load(c, p.y_axis[2]);
    y = v[0] * a + v[1] * b + v[2] * c;
    load(a, p.z_axis[0]), load(b, p.z_axis[1]), load(c, p.z_axis[2]);
    z = v[0] * a + v[1] * b + v[2] * c;
    left = x < Floats{};
    x = left ? -x : x;
  }
};

/// The half of each lane's triangle on a point's side.
struct HalfLanes {
  Floats width, normal_x, normal_y, hypotenuse;

  FINGERPAD_INLINED HalfLanes(const TrianglePacket& p, const Bits& left) noexcept {
    Floats a, b;
    load(a, p.half[0].width), load(b, p.half[1].width);
    width = left ? b : a;
    load(a, p.half[0].normal_x), load(b, p.half[1].normal_x);
    normal_x = left ? b : a;
    load(a, p.half[0].normal_y), load(b, p.half[1].normal_y);
    normal_y = left ? b : a;
    load(a, p.half[0].hypotenuse), load(b, p.half[1].hypotenuse);
    hypotenuse = left ? b : a;
  }
};

}  // namespace fingerpad
