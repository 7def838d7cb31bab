#include "contact/packet_filter.hpp"

#include "contact/float_lanes.hpp"

namespace fingerpad {
namespace {

using float_lanes::EightBits;
using float_lanes::EightFloats;
using float_lanes::HalfLanes;
using float_lanes::InFrames;
using float_lanes::load;
using float_lanes::take_halves;
using float_lanes::take_roots;
using float_lanes::to_mask;
using float_lanes::turn;

/// See rough_margin for the error of each step.
FINGERPAD_INLINED unsigned filter(const TrianglePacket& p, const float* r, float limit2,
                                  RoughDistances& rough) noexcept {
  const EightFloats zero = {};
  EightFloats v[3], a;
  for (int i = 0; i < 3; ++i) {
    load(a, p.foot[i]);
    v[i] = r[i] - a;
  }
  InFrames at;
  turn(at, p, v);
  const EightFloats &y = at.y, &z = at.z;
  const EightBits left = at.x < zero;
  HalfLanes half;
  take_halves(half, p, left);
  const EightFloats x = left ? -at.x : at.x;

  const EightFloats beyond = x - half.width;
  const EightFloats above = beyond * half.normal_x + y * half.normal_y;
  const EightFloats along = y * half.normal_x - beyond * half.normal_y;
  const EightFloats over = along - half.hypotenuse;
  EightFloats off = over > -along ? over : -along;
  off = off > zero ? off : zero;
  const EightFloats above_only = above > zero ? above : zero;
  const EightFloats beyond_only = beyond > zero ? beyond : zero;
  const EightFloats near_hypotenuse = above_only * above_only + off * off;
  const EightFloats near_base = beyond_only * beyond_only + y * y;
  const EightFloats squared = z * z + (y < zero ? near_base : near_hypotenuse);
  *reinterpret_cast<EightFloats*>(rough.squared.data()) = squared;
  return to_mask(squared <= limit2);
}

/// See disc_margin for the error of each step.
FINGERPAD_INLINED std::uint64_t filter_discs(const PacketDiscs* discs, int groups, const float* point,
                                             float limit, float lost2) noexcept {
  const EightFloats zero = {};
  std::uint64_t near = 0;
  for (int group = 0; group < groups; ++group) {
    EightFloats height = zero, away2 = zero, a, b;
    for (int i = 0; i < 3; ++i) {
      load(a, discs[group].centre[i]), load(b, discs[group].across[i]);
      const EightFloats off = point[i] - a;
      height += off * b;
      away2 += off * off;
    }
    load(a, discs[group].radius), load(b, discs[group].thick);
    EightFloats along = away2 - height * height - lost2;
    along = along > zero ? along : zero;
    take_roots(along);
    EightFloats above = (height < zero ? -height : height) - b, beside = along - a;
    above = above > zero ? above : zero;
    beside = beside > zero ? beside : zero;
    const EightBits within = above * above + beside * beside <= limit * limit;
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
