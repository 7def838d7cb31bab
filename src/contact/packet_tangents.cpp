#include "contact/packet_tangents.hpp"

#include <cmath>
#include <limits>

#include "contact/packet_lanes.hpp"

namespace fingerpad {
namespace {

FINGERPAD_INLINED Floats largest(const Floats& a, const Floats& b) noexcept {
  return a > b ? a : b;
}

FINGERPAD_INLINED Floats roots(const Floats& squared) noexcept {
  alignas(32) TrianglePacket::Lanes lanes;
  store(lanes, squared);
  for (float& lane : lanes) lane = std::sqrt(lane);
  Floats v;
  load(v, lanes);
  return v;
}

/// From the closest points to a point, in frames: see TrianglePacket.
struct WayToPoint {
  Floats x, y, z;

  FINGERPAD_INLINED WayToPoint(const InFrames& at, const HalfLanes& half) noexcept : z(at.z) {
    const Floats zero = {};
    const Floats beyond = at.x - half.width;
    const Floats above = beyond * half.normal_x + at.y * half.normal_y;
    const Floats along = at.y * half.normal_x - beyond * half.normal_y;
    // Over the hypotenuse: square to it, and beyond one of its ends along it.
    const Floats over = along - half.hypotenuse;
    const Floats off = along < zero ? along : largest(over, zero);
    const Bits is_inside = above <= zero, is_below = at.y < zero;
    const Floats over_x = is_inside ? zero : above * half.normal_x - off * half.normal_y;
    const Floats over_y = is_inside ? zero : above * half.normal_y + off * half.normal_x;
    x = is_below ? largest(beyond, zero) : over_x;
    y = is_below ? at.y : over_y;
  }
};

/// How far the triangles reach from their frames' origins along a vector in these.
FINGERPAD_INLINED Floats reach_in_frames(const TrianglePacket& p, const Floats& x, const Floats& y) noexcept {
  Floats right, left, normal, hypotenuse;
  load(right, p.half[0].width), load(left, p.half[1].width);
  load(normal, p.half[0].normal_x), load(hypotenuse, p.half[0].hypotenuse);
  return largest(largest(x * right, -(x * left)), y * (normal * hypotenuse));
}

/// Half spaces made from a point, in registers.
struct Tangents {
  Floats towards[3], level;

  FINGERPAD_INLINED explicit Tangents(const PacketTangents& known) noexcept {
    for (int i = 0; i < 3; ++i) load(towards[i], known.towards[i]);
    load(level, known.level);
  }

  template <class Coordinate>
  FINGERPAD_INLINED Tangents(const TrianglePacket& p, const Coordinate* r) noexcept : level{} {
    const Floats zero = {}, one = zero + 1;
    const InFrames at(p, r);
    const HalfLanes half(p, at.left);
    const WayToPoint way(at, half);
    const Floats squared = way.x * way.x + way.y * way.y + way.z * way.z;
    const Bits is_apart = squared > zero;
    const Floats inverse = one / (is_apart ? roots(squared) : one);
    const Floats across = is_apart ? way.x * inverse : zero;
    const Floats y = is_apart ? way.y * inverse : zero;
    const Floats z = is_apart ? way.z * inverse : one;
    const Floats x = at.left ? -across : across;
    Floats a, b, c;
    for (int i = 0; i < 3; ++i) {
      load(a, p.x_axis[i]), load(b, p.y_axis[i]), load(c, p.z_axis[i]);
      towards[i] = x * a + y * b + z * c;
      load(a, p.foot[i]);
      level += towards[i] * a;
    }
    level += reach_in_frames(p, x, y);
  }

  /// How far outside of them a point is.
  template <class Coordinate>
  FINGERPAD_INLINED Floats outside(const Coordinate* r) const noexcept {
    return r[0] * towards[0] + r[1] * towards[1] + r[2] * towards[2] - level;
  }
};

FINGERPAD_INLINED void make(const TrianglePacket& p, const float* r, PacketTangents& made) noexcept {
  const Tangents tangents(p, r);
  for (int i = 0; i < 3; ++i) store(made.towards[i], tangents.towards[i]);
  store(made.level, tangents.level);
}

/// What half spaces tell of a way.
struct Told {
  Floats here, ends;  ///< how far outside of them the way begins, and ends, at least
  Bits left;          ///< those that may block it

  FINGERPAD_INLINED Told(const Floats& begins, const Floats& there, const WayPastPacket& way) noexcept
      : here(begins) {
    const Floats least = Floats{} + std::numeric_limits<float>::min();
    ends = there - way.turn / largest(here, least);
    left = ~(((there >= way.touched) & (here >= way.touched)) | (here > way.begins) | (ends > way.ends));
  }
};

FINGERPAD_INLINED unsigned may_block(const PacketTangents& known, const WayPastPacket& way,
                                     TrianglePacket::Lanes& ends) noexcept {
  const Tangents tangents(known);
  const Told told(tangents.outside(way.from), tangents.outside(way.to), way);
  store(ends, told.ends);
  return to_mask(told.left);
}

/// How often half spaces are made anew on the way.
constexpr int most_steps = 2;

FINGERPAD_INLINED unsigned may_block_swept(const TrianglePacket& p, const PacketTangents& known,
                                           const WayPastPacket& way, TrianglePacket::Lanes& ends) noexcept {
  const Floats zero = {}, one = zero + 1;
  const Tangents first(known);
  Floats here = first.outside(way.from), there = first.outside(way.to), share = zero;
  const Told told(here, there, way);
  Floats ends_at = told.ends;
  Bits left = told.left;
  for (int step = 0; step < most_steps && to_mask(left) != 0; ++step) {
    // As far as the last half space shows the way free; the next one must show as much there.
    constexpr float shorter = 1 - 0x1p-20F;
    const Floats free = here - (way.touched + 2 * way.margin);
    const Bits goes_on = left & (free > zero) & (there < here);
    if (to_mask(goes_on) == 0) break;
    share += goes_on ? (one - share) * shorter * (free / (here - there)) : zero;
    Floats at[3];
    for (int i = 0; i < 3; ++i) at[i] = way.from[i] + share * (way.to[i] - way.from[i]);
    const Tangents next(p, at);
    here = next.outside(at);
    there = next.outside(way.to);
    const Told told_next(here, there, way);
    ends_at = largest(ends_at, told_next.ends);
    left &= told_next.left;
  }
  store(ends, ends_at);
  return to_mask(left);
}

FINGERPAD_INLINED unsigned reach_within(const TrianglePacket& p, const float* along, float limit) noexcept {
  Floats a, x = {}, y = {}, level = {};
  for (int i = 0; i < 3; ++i) {
    load(a, p.x_axis[i]), x += along[i] * a;
    load(a, p.y_axis[i]), y += along[i] * a;
    load(a, p.foot[i]), level += along[i] * a;
  }
  return to_mask(level + reach_in_frames(p, x, y) <= limit);
}

void make_plain(const TrianglePacket& p, const float* r, PacketTangents& made) noexcept {
  make(p, r, made);
}

unsigned may_block_plain(const PacketTangents& tangents, const WayPastPacket& way,
                         TrianglePacket::Lanes& ends) noexcept {
  return may_block(tangents, way, ends);
}

unsigned may_block_swept_plain(const TrianglePacket& packet, const PacketTangents& tangents,
                               const WayPastPacket& way, TrianglePacket::Lanes& ends) noexcept {
  return may_block_swept(packet, tangents, way, ends);
}

unsigned reach_within_plain(const TrianglePacket& p, const float* along, float limit) noexcept {
  return reach_within(p, along, limit) & ~static_cast<unsigned>(p.always_exact);
}

#if defined(__x86_64__)
[[gnu::target("avx2")]] void make_with_avx2(const TrianglePacket& p, const float* r,
                                            PacketTangents& made) noexcept {
  make(p, r, made);
}

[[gnu::target("avx2")]] unsigned may_block_with_avx2(const PacketTangents& tangents, const WayPastPacket& way,
                                                     TrianglePacket::Lanes& ends) noexcept {
  return may_block(tangents, way, ends);
}

[[gnu::target("avx2")]] unsigned may_block_swept_with_avx2(const TrianglePacket& packet,
                                                           const PacketTangents& tangents,
                                                           const WayPastPacket& way,
                                                           TrianglePacket::Lanes& ends) noexcept {
  return may_block_swept(packet, tangents, way, ends);
}

[[gnu::target("avx2")]] unsigned reach_within_with_avx2(const TrianglePacket& p, const float* along,
                                                        float limit) noexcept {
  return reach_within(p, along, limit) & ~static_cast<unsigned>(p.always_exact);
}
#endif

}  // namespace

PacketTangents no_tangents() noexcept {
  PacketTangents none{};
  none.level.fill(std::numeric_limits<float>::infinity());
  return none;
}

TangentMaker plain_tangent_maker() noexcept {
  return make_plain;
}

WayFilter plain_way_filter() noexcept {
  return may_block_plain;
}

TangentMaker fastest_tangent_maker() noexcept {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) return make_with_avx2;
#endif
  return make_plain;
}

WayFilter fastest_way_filter() noexcept {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) return may_block_with_avx2;
#endif
  return may_block_plain;
}

SweepFilter plain_sweep_filter() noexcept {
  return may_block_swept_plain;
}

SweepFilter fastest_sweep_filter() noexcept {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) return may_block_swept_with_avx2;
#endif
  return may_block_swept_plain;
}

ReachFilter plain_reach_filter() noexcept {
  return reach_within_plain;
}

ReachFilter fastest_reach_filter() noexcept {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) return reach_within_with_avx2;
#endif
  return reach_within_plain;
}

}  // namespace fingerpad
