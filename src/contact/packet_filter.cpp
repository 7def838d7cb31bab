#include "contact/packet_filter.hpp"

#include "contact/packet_lanes.hpp"

namespace fingerpad {
namespace {

/// See rough_margin for the error of each step.
FINGERPAD_INLINED unsigned filter(const TrianglePacket& p, const float* r, float limit2,
                                  RoughDistances& rough) noexcept {
  const Floats zero = {};
  const InFrames at(p, r);
  const auto& [x, y, z, left] = at;
  const HalfLanes half(p, left);
  const auto& [width, normal_x, normal_y, hypotenuse] = half;

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
  store(rough.squared, squared);
  return to_mask(squared <= limit2);
}

FINGERPAD_INLINED std::uint64_t filter_boxes(const PacketBoxes* boxes, int groups, const float* point,
                                             float radius2) noexcept {
  const Floats zero = {};
  std::uint64_t near = 0;
  for (int group = 0; group < groups; ++group) {
    Floats squared = zero, centre, half;
    for (int i = 0; i < 3; ++i) {
      load(centre, boxes[group].centre[i]), load(half, boxes[group].half[i]);
      const Floats from_centre = point[i] - centre;
      Floats beyond = (from_centre < zero ? -from_centre : from_centre) - half;
      beyond = beyond > zero ? beyond : zero;
      squared += beyond * beyond;
    }
    near |= std::uint64_t{to_mask(squared <= radius2)} << (packet_width * group);
  }
  return near;
}

unsigned plain(const TrianglePacket& p, const float* r, float limit2, RoughDistances& rough) noexcept {
  return filter(p, r, limit2, rough);
}

std::uint64_t plain_boxes(const PacketBoxes* boxes, int groups, const float* point, float radius2) noexcept {
  return filter_boxes(boxes, groups, point, radius2);
}

#if defined(__x86_64__)
[[gnu::target("avx2")]] unsigned with_avx2(const TrianglePacket& p, const float* r, float limit2,
                                           RoughDistances& rough) noexcept {
  return filter(p, r, limit2, rough);
}

[[gnu::target("avx2")]] std::uint64_t boxes_with_avx2(const PacketBoxes* boxes, int groups,
                                                      const float* point, float radius2) noexcept {
  return filter_boxes(boxes, groups, point, radius2);
}
#endif

}  // namespace

PacketFilter plain_packet_filter() noexcept {
  return plain;
}

BoxFilter plain_box_filter() noexcept {
  return plain_boxes;
}

BoxFilter fastest_box_filter() noexcept {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) return boxes_with_avx2;
#endif
  return plain_boxes;
}

PacketFilter fastest_packet_filter() noexcept {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) return with_avx2;
#endif
  return plain;
}

}  // namespace fingerpad
