#include "contact/packet_filter.hpp"

#include <cmath>

// Vectors of eight floats wider than the plain instruction set has are split by the compiler; they never
// cross a call that is not inlined, so how they would be passed does not matter.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace fingerpad {
namespace {

using Floats [[gnu::vector_size(sizeof(float) * packet_width)]] = float;
using Bits [[gnu::vector_size(sizeof(int) * packet_width)]] = int;

#define FINGERPAD_INLINED [[gnu::always_inline]] inline

FINGERPAD_INLINED void load(Floats& v, const TrianglePacket::Lanes& lanes) noexcept {
  v = *reinterpret_cast<const Floats*>(lanes.data());
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

/// See rough_margin for the error of each step.
FINGERPAD_INLINED unsigned filter(const TrianglePacket& p, const float* r, float limit2,
                                  RoughDistances& rough) noexcept {
  const Floats zero = {};
  Floats v[3], a, b, c;
  for (int i = 0; i < 3; ++i) {
    load(a, p.foot[i]);
    v[i] = r[i] - a;
  }
  const auto& axes_x = p.x_axis;
  const auto& axes_y = p.y_axis;
  const auto& axes_z = p.z_axis;
  load(a, axes_x[0]), load(b, axes_x[1]), load(c, axes_x[2]);
  Floats x = v[0] * a + v[1] * b + v[2] * c;
  load(a, axes_y[0]), load(b, axes_y[1]), load(c, axes_y[2]);
  const Floats y = v[0] * a + v[1] * b + v[2] * c;
  load(a, axes_z[0]), load(b, axes_z[1]), load(c, axes_z[2]);
  const Floats z = v[0] * a + v[1] * b + v[2] * c;

  const Bits left = x < zero;
  Floats width, normal_x, normal_y, hypotenuse;
  load(a, p.half[0].width), load(b, p.half[1].width);
  width = left ? b : a;
  load(a, p.half[0].normal_x), load(b, p.half[1].normal_x);
  normal_x = left ? b : a;
  load(a, p.half[0].normal_y), load(b, p.half[1].normal_y);
  normal_y = left ? b : a;
  load(a, p.half[0].hypotenuse), load(b, p.half[1].hypotenuse);
  hypotenuse = left ? b : a;
  x = left ? -x : x;

  const Floats beyond = x - width;
  const Floats above = beyond * normal_x + y * normal_y;
  const Floats along = y * normal_x - beyond * normal_y;
  const Floats over = along - hypotenuse;
  Floats off = over > -along ? over : -along;
  off = off > zero ? off : zero;
  const Floats above_only = above > zero ? above : zero;
  const Floats beyond_only = beyond > zero ? beyond : zero;
  const Floats near_hypotenuse = above_only * above_only + off * off;
  const Floats near_base = beyond_only * beyond_only + y * y;
  const Floats squared = z * z + (y < zero ? near_base : near_hypotenuse);
  *reinterpret_cast<Floats*>(rough.squared.data()) = squared;
  return to_mask(squared <= limit2);
}

FINGERPAD_INLINED void take_roots(Floats& v) noexcept {
#if defined(__SSE__)
  using Four [[gnu::vector_size(16)]] = float;
  Four* half = reinterpret_cast<Four*>(&v);
  half[0] = __builtin_ia32_sqrtps(half[0]);
  half[1] = __builtin_ia32_sqrtps(half[1]);
#else
  for (int i = 0; i < packet_width; ++i) v[i] = std::sqrt(v[i]);
#endif
}

/// See disc_margin for the error of each step.
FINGERPAD_INLINED std::uint64_t filter_discs(const PacketDiscs* discs, int groups, const float* point,
                                             float limit, float lost2) noexcept {
  const Floats zero = {};
  std::uint64_t near = 0;
  for (int group = 0; group < groups; ++group) {
    Floats height = zero, away2 = zero, a, b;
    for (int i = 0; i < 3; ++i) {
      load(a, discs[group].centre[i]), load(b, discs[group].across[i]);
      const Floats off = point[i] - a;
      height += off * b;
      away2 += off * off;
    }
    load(a, discs[group].radius), load(b, discs[group].thick);
    Floats along = away2 - height * height - lost2;
    along = along > zero ? along : zero;
    take_roots(along);
    Floats above = (height < zero ? -height : height) - b, beside = along - a;
    above = above > zero ? above : zero;
    beside = beside > zero ? beside : zero;
    const Bits within = above * above + beside * beside <= limit * limit;
    near |= std::uint64_t{to_mask(within)} << (packet_width * group);
  }
  return near;
}

unsigned plain(const TrianglePacket& p, const float* r, float limit2, RoughDistances& rough) noexcept {
  return filter(p, r, limit2, rough);
}

std::uint64_t plain_discs(const PacketDiscs* discs, int groups, const float* point, float limit,
                          float lost2) noexcept {
  return filter_discs(discs, groups, point, limit, lost2);
}

#if defined(__x86_64__)
[[gnu::target("avx2")]] unsigned with_avx2(const TrianglePacket& p, const float* r, float limit2,
                                           RoughDistances& rough) noexcept {
  return filter(p, r, limit2, rough);
}

[[gnu::target("avx2")]] std::uint64_t discs_with_avx2(const PacketDiscs* discs, int groups,
                                                      const float* point, float limit, float lost2) noexcept {
  return filter_discs(discs, groups, point, limit, lost2);
}
#endif

}  // namespace

PacketFilter plain_packet_filter() noexcept {
  return plain;
}

DiscFilter plain_disc_filter() noexcept {
  return plain_discs;
}

DiscFilter fastest_disc_filter() noexcept {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) return discs_with_avx2;
#endif
  return plain_discs;
}

PacketFilter fastest_packet_filter() noexcept {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) return with_avx2;
#endif
  return plain;
}

}  // namespace fingerpad
