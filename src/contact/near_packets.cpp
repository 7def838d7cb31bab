#include <algorithm>
#include <bit>
#include <limits>

#include "contact/near_packets.hpp"

// Which packets are near a point or a way, from cluster to cluster.

namespace fingerpad {

namespace {

// A float holds the square of no length beyond about this.
constexpr double beyond_floats = 1e15;
// A way that is shorter is a point, of which clusters tell no more than of its box.
constexpr double shortest_way = 1e-6;

bool fits_floats(const Vec3& at) noexcept {
  return at.cwiseAbs().maxCoeff() < beyond_floats;
}

}  // namespace

WindingNumber::NearPackets::NearPackets(const WindingNumber& clusters, const Vec3& at, double radius,
                                        const Vec3& half, About about, std::size_t from) noexcept
    : clusters_(&clusters),
      is_far_(!fits_floats(at) || !fits_floats(half)),
      around_(is_far_ ? Around(Vec3::Zero(), beyond_floats) : Around(at, radius, half)),
      is_way_(about == About::way && !is_far_ && half.squaredNorm() > shortest_way * shortest_way),
      level_(clusters.top()),
      at_(at),
      half_(half),
      radius_(radius) {
  if (from == 0) {
    look_into(0);
    return;
  }
  near_[level_] = 0;
  if (from >= clusters.packet_count_) return;
  // On each level the cluster that `from` is in has been gone into; on the lowest it is yet to be.
  for (level_ = 0;; ++level_) {
    const std::size_t index = from >> (branching_bits * level_), lane = index % branching;
    look_into(index - lane);
    near_[level_] &= ~0U << (level_ == 0 ? lane : lane + 1);
    if (level_ == clusters.top()) break;
  }
  level_ = 0;
}

/// Of the four clusters those of which no ball around comes within the radius of the way.
void WindingNumber::NearPackets::leave_beside(const Four& four) noexcept {
  constexpr double rounding = 1e-5;
  ++tests_;
  const double per_length2 = 1 / half_.squaredNorm();
  for (unsigned among = near_[level_]; among != 0; among &= among - 1) {
    const int k = std::countr_zero(among);
    const Vec3 off = Vec3(four.middle[0][k], four.middle[1][k], four.middle[2][k]) - at_;
    const double size = Vec3(four.half[0][k], four.half[1][k], four.half[2][k]).norm();
    const double share = std::clamp(off.dot(half_) * per_length2, -1.0, 1.0);
    const double reach = radius_ + size + rounding * (1 + radius_ + size);
    if ((off - share * half_).squaredNorm() > reach * reach) near_[level_] &= ~(1U << k);
  }
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
