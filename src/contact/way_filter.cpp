#include "contact/way_filter.hpp"

#include "contact/float_lanes.hpp"
#include "contact/proxy_limits.hpp"

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

/// Tangents to each triangle's distance along the way. Of eight triangles seven are left out by walls, planes
/// and the first tangent; the others are taken in one packet of eight.
constexpr int tangents = 3;
static_assert(tangents < ProxyLimits::newton_steps,
              "a sweep that is cut short goes on for longer than the filter");

FINGERPAD_INLINED EightFloats at_least_0(const EightFloats& v) {
  return v > EightFloats{} ? v : EightFloats{};
}

/// Of the lanes' triangles those that stand behind a wall.
FINGERPAD_INLINED void hide(EightBits& out, const TrianglePacket& p, const RoughWay::Wall& wall) {
  const EightFloats zero = {};
  EightFloats foot = zero, normal[3], a, b;
  for (int i = 0; i < 3; ++i) {
    normal[i] = wall.normal[static_cast<std::size_t>(i)] + zero;
    load(a, p.foot[static_cast<std::size_t>(i)]);
    foot += normal[i] * a;
  }
  InFrames n;
  turn(n, p, normal);
  load(a, p.half[0].normal_x), load(b, p.half[0].hypotenuse);
  EightFloats highest = n.y * (a * b);  // at the top of the altitude
  load(a, p.half[0].width), load(b, p.half[1].width);
  const EightFloats right = n.x * a, left = -n.x * b;
  highest = highest > right ? highest : right;
  highest = highest > left ? highest : left;
  out |= foot + highest <= wall.offset;
}

/// The vector from a triangle's closest point to a place, see `filter` in packet_filter.cpp; x is mirrored
/// where the place is on the left.
FINGERPAD_INLINED void to_place(InFrames& v, const TrianglePacket& p, const InFrames& place,
                                const EightBits& is_left) {
  const EightFloats zero = {};
  HalfLanes half;
  take_halves(half, p, is_left);
  const EightFloats beyond = (is_left ? -place.x : place.x) - half.width;
  const EightFloats above = at_least_0(beyond * half.normal_x + place.y * half.normal_y);
  const EightFloats along = place.y * half.normal_x - beyond * half.normal_y;
  const EightFloats off = at_least_0(along - half.hypotenuse) + (along < zero ? along : zero);
  const EightBits is_below = place.y < zero;
  v.x = is_below ? at_least_0(beyond) : above * half.normal_x - off * half.normal_y;
  v.y = is_below ? place.y : above * half.normal_y + off * half.normal_x;
  v.z = place.z;
}

/// See way_margin.
FINGERPAD_INLINED unsigned filter_way(const TrianglePacket& p, const RoughWay& w) {
  const EightFloats zero = {};
  const EightFloats margin = w.margin + zero, length = w.length + zero;
  EightFloats off[3], along[3];
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    load(off[i], p.foot[k]);
    off[i] = w.start[k] - off[i];
    along[i] = w.way[k] + zero;
  }
  InFrames start, way;
  turn(start, p, off);
  turn(way, p, along);

  EightBits out = {};
  for (std::size_t k = 0; k < w.wall_count; ++k) hide(out, p, w.walls[k]);
  const EightFloats side_z = start.z < zero ? -start.z : start.z, end_z = start.z < zero ? -way.z : way.z;
  out |= (side_z - margin > w.clearance) & (side_z + end_z - w.clearance - 2 * margin > w.worst);

  EightFloats share = zero;
  for (int k = 0;; ++k) {
    InFrames v;
    const InFrames place = {start.x + share * way.x, start.y + share * way.y, start.z + share * way.z};
    const EightBits is_left = place.x < zero;
    to_place(v, p, place, is_left);
    EightFloats distance = v.x * v.x + v.y * v.y + v.z * v.z;
    take_roots(distance);
    const EightFloats per_distance = 1 / distance;
    const EightFloats slope = (v.x * (is_left ? -way.x : way.x) + v.y * way.y + v.z * way.z) * per_distance;
    const EightFloats slope_margin = 2 * margin * length * per_distance, gap = distance - w.clearance;
    out |= gap + (1 - share) * slope - 2 * margin - slope_margin > w.worst;
    const unsigned left = ~to_mask(out) & 0xffU;
    if (left == 0 || k + 1 == tangents) return left;
    const EightFloats steepest = slope_margin + margin - slope;
    const EightFloats nearer = at_least_0(gap - margin) / (steepest > margin ? steepest : margin);
    share = share + nearer < 1 + zero ? share + nearer : 1 + zero;
  }
}

unsigned plain_way(const TrianglePacket& packet, const RoughWay& way) noexcept {
  return filter_way(packet, way);
}

#if defined(__x86_64__)
[[gnu::target("avx2")]] unsigned way_with_avx2(const TrianglePacket& packet, const RoughWay& way) noexcept {
  return filter_way(packet, way);
}
#endif

}  // namespace

WayFilter plain_way_filter() noexcept {
  return plain_way;
}

WayFilter fastest_way_filter() noexcept {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) return way_with_avx2;
#endif
  return plain_way;
}

}  // namespace fingerpad
