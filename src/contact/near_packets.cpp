#include "contact/near_packets.hpp"

#include <limits>

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
      level_(clusters.top()) {
  if (about == About::way && !is_far_ && half.squaredNorm() > shortest_way * shortest_way)
    along_.emplace(at, radius, half);
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
