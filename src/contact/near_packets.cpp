#include <algorithm>
#include <bit>
#include <limits>

#include "contact/winding_number.hpp"

// Which packets are near a point or a way, from cluster to cluster.

namespace fingerpad {

/// Of some of four clusters those of which a ball around comes within a radius of a way.
unsigned WindingNumber::beside(const Four& four, unsigned among, const Vec3& at, const Vec3& half,
                               double radius) noexcept {
  constexpr double rounding = 1e-5;
  const double per_length2 = 1 / half.squaredNorm();
  unsigned near = 0;
  for (; among != 0; among &= among - 1) {
    const int k = std::countr_zero(among);
    const Vec3 off = Vec3(four.middle[0][k], four.middle[1][k], four.middle[2][k]) - at;
    const double size = Vec3(four.half[0][k], four.half[1][k], four.half[2][k]).norm();
    const double share = std::clamp(off.dot(half) * per_length2, -1.0, 1.0);
    const double reach = radius + size + rounding * (1 + radius + size);
    if ((off - share * half).squaredNorm() <= reach * reach) near |= 1U << k;
  }
  return near;
}

std::size_t WindingNumber::next_near(std::size_t packet, const Vec3& at, double radius, long& tests,
                                     const Vec3& half) const noexcept {
  constexpr double beyond_floats = 1e15;
  if (!(at.cwiseAbs().maxCoeff() < beyond_floats)) return std::min(packet, packet_count_);
  const Around around(at, radius, half);
  constexpr double shortest2 = 1e-12;
  const bool is_way = half.squaredNorm() > shortest2;
  while (packet < packet_count_) {
    // The largest cluster that begins here, beside those after it; of the first that is near, its parts.
    for (std::size_t level = widest_level(packet);; --level) {
      const std::size_t index = packet >> (branching_bits * level);
      ++tests;
      unsigned near = around.near(four(level, index)) >> (index % branching);
      if (is_way && near != 0) {
        ++tests;
        near =
            beside(four(level, index), near << (index % branching), at, half, radius) >> (index % branching);
      }
      if (near == 0) {
        packet = (index / branching + 1) << (branching_bits * (level + 1));
        break;
      }
      packet = (index + static_cast<unsigned>(std::countr_zero(near))) << (branching_bits * level);
      if (level == 0) return packet;
    }
  }
  return packet_count_;
}

std::size_t WindingNumber::some_near(const Vec3& at) const noexcept {
  std::size_t index = 0;
  for (std::size_t level = top(); level-- > 0;) {
    const std::size_t first = index * branching;
    const Four& here = four(level, first);
    double least2 = std::numeric_limits<double>::infinity();
    index = first;
    for (std::size_t k = 0; k < branching; ++k) {
      const double distance2 =
          (Vec3(here.middle[0][k], here.middle[1][k], here.middle[2][k]) - at).squaredNorm();
      if (!(distance2 < least2)) continue;
      least2 = distance2;
      index = first + k;
    }
  }
  return index;
}

}  // namespace fingerpad
