#include "contact/closest_memory.hpp"

#include <algorithm>
#include <cmath>

#include "contact/closest_search.hpp"
#include "contact/tree_parts.hpp"

namespace fingerpad {
namespace {

/// A list is made for so many steps of the path, and not where it would serve fewer than `least_steps`.
constexpr double steps_ahead = 24, least_steps = 6;
/// In radii of the packet that holds the closest triangle: how long a way a list serves at least and at most.
constexpr double least_way = 1, longest_way = 2.5;
/// Where nothing is within reach, it serves more steps, as nothing need be looked at.
constexpr double free_steps_ahead = 200;
/// One that stands off the surface stands ahead too, by so much of its way, as the path goes on as it came;
/// by less where it was given less lift.
constexpr double ahead_share = 0.5;
/// A lift for which there is no room is halved, down to none, and grows again slowly.
constexpr double least_lift = 0.5, lift_growth = 1.1;
/// Queries without a list after one that did not pay.
constexpr int pause_queries = 64;
/// Of clusters: a gathering that takes more is given up.
constexpr long most_tests = 400;
/// Rounding of a distance between two points, in sizes of the part.
constexpr double distance_rounding = 1e-12;

}  // namespace

/// Lists the packets that come within a ball, or the nearest of them to its middle. Scaled.
struct PacketGathering {
  ClosestMemory& memory;
  Vec3 about;
  double radius;  ///< what is farther is not listed
  std::array<double, ClosestMemory::most> distance{};
  std::size_t farthest = 0;

  PacketGathering(ClosestMemory& into, const Vec3& anchor, const Vec3& middle, double within) noexcept
      : memory(into), about(middle), radius(within) {
    memory.count_ = 0;
    memory.spread_ = 0;
    memory.anchor_ = anchor;
  }

  bool is_full() const noexcept { return memory.count_ == ClosestMemory::most; }

  void offer(const PacketDisc& disc, std::uint32_t index) noexcept {
    const double away = disc.least_distance(about);
    if (away > radius) return;
    std::size_t place = farthest;
    if (is_full()) {
      radius = std::min(radius, std::max(away, distance[farthest]));
      if (away >= distance[farthest]) return;
    } else {
      place = static_cast<std::size_t>(memory.count_++);
    }
    distance[place] = away;
    put(disc, index, place);
    if (is_full())
      farthest =
          static_cast<std::size_t>(std::max_element(distance.begin(), distance.end()) - distance.begin());
  }

 private:
  void put(const PacketDisc& disc, std::uint32_t index, std::size_t place) noexcept {
    memory.packet_[place] = index;
    PacketDiscs& discs = memory.discs_[place / packet_width];
    const std::size_t lane = place % packet_width;
    float reaches = disc.radius + disc.thick;
    for (std::size_t i = 0; i < 3; ++i) {
      discs.centre[i][lane] =
          static_cast<float>(static_cast<double>(disc.centre[i]) - memory.anchor_[static_cast<int>(i)]);
      discs.across[i][lane] = disc.across[i];
      reaches += std::abs(discs.centre[i][lane]);
    }
    discs.radius[lane] = disc.radius;
    discs.thick[lane] = disc.thick;
    memory.spread_ = std::max(memory.spread_, reaches);
  }
};

/// The way that the path goes along the surface, at most of length 1; nothing where it has only begun.
Vec3 forward(const ClosestSearch& search, const Vec3& step, double near_m) noexcept {
  const double step_m = step.norm();
  if (!(step_m > 0 && step_m < std::numeric_limits<double>::infinity())) return Vec3::Zero();
  const Vec3 way = step / step_m;
  if (!(near_m > 0)) return way;
  const Vec3 off = (search.q - search.winner.at.point) / near_m;
  return way - way.dot(off) * off;
}

/// Lists what stands around the way to come, if that pays. Costs no more than `most_tests` and as many
/// packets.
/// @param search    has looked at its seed
/// @param step      how far the path went since the last query, and which way [m]
void TriangleTree::Impl::list_packets(const ClosestSearch& search, const Vec3& step,
                                      ClosestMemory& memory) const noexcept {
  const bool poor = memory.clear_m_ >= 0 && memory.served_ < least_steps;
  memory.forget_packets();
  if (poor) memory.pause_ = pause_queries;
  if (memory.pause_ > 0) {
    --memory.pause_;
    return;
  }
  const double step_m = step.norm();
  const double near_m = std::sqrt(search.winner.at.distance2_m2);  // the reach where there is none
  Vec3 about = search.q;
  double lift_m = 0, way_m = std::max(free_steps_ahead * step_m, near_m / 8), ahead_m = way_m,
         served_m = way_m;
  if (search.won_in != nullptr) {
    const double radius_m = static_cast<double>(search.won_in->radius) / packed.scale;
    way_m = std::clamp(steps_ahead * step_m, least_way * radius_m, longest_way * radius_m);
    ahead_m = served_m = way_m;
    if (near_m > way_m / 2 && memory.lift_ > least_lift) {
      const double ahead = ahead_share * memory.lift_ / ClosestMemory::greatest_lift;
      way_m = std::min(way_m, longest_way * radius_m / (1 + ahead));
      served_m = (1 + ahead) * way_m;
      lift_m = memory.lift_ * way_m;
      about += lift_m / near_m * (search.q - search.winner.at.point);
      // Straight on, and along a surface that is as curved as the ball.
      ahead_m = way_m * way_m * (0.5 / lift_m + 0.5 / (lift_m + near_m)) * 1.1;
      about += forward(search, step, near_m) * (ahead * way_m);
    }
  }
  const double within = (lift_m + near_m + ahead_m) * packed.scale;
  if (!(served_m >= least_steps * step_m) || !(within < static_cast<double>(far_off))) return;

  PacketGathering gathering(memory, search.scaled, about * packed.scale, within);
  // It must hold the ball of this query, and those of some of the next.
  const double held_m = (search.q - about).norm() + near_m;
  const double least = (held_m + std::max(0.0, lift_m + near_m + ahead_m - held_m) / 4) * packed.scale;
  WindingNumber::NearPackets near(winding, gathering.about, gathering.radius);
  for (std::size_t next = 0; near.tests() <= most_tests && gathering.radius > least && near.next(next);) {
    gathering.offer(packed.discs[next], static_cast<std::uint32_t>(next));
    near.shrink(gathering.radius);
  }
  const bool fits = near.tests() <= most_tests && gathering.radius > least;
  if (!fits) {
    memory.forget_packets();
    if (!(lift_m > 0)) memory.pause_ = pause_queries;
    memory.lift_ /= 2;
    return;
  }
  memory.lift_ = std::clamp(memory.lift_ * lift_growth, least_lift, ClosestMemory::greatest_lift);
  memory.clear_m_ = gathering.radius / packed.scale * (1 - distance_rounding);
  memory.about_ = about;
  memory.served_ = 0;
}

/// Whether no packet that is not listed can hold a triangle as near as `distance_m`.
bool ClosestMemory::covers(const Vec3& q, double distance_m, double rounding_m) const noexcept {
  return clear_m_ - (q - about_).norm() > distance_m + rounding_m;
}

/// Looks at the packets listed that could hold something nearer.
void TriangleTree::Impl::look_through(ClosestSearch& search, const ClosestMemory& memory) const noexcept {
  float at[3], spread = memory.spread_;
  for (int i = 0; i < 3; ++i) {
    at[i] = static_cast<float>(search.scaled[i] - memory.anchor_[i]);
    spread += std::abs(at[i]);
  }
  const float limit = search.best + disc_margin * spread + search.exact_margin;
  const int groups = (memory.count_ + packet_width - 1) / packet_width;
  std::uint64_t near = disc_filter(memory.discs_.data(), groups, at, limit, disc_margin * (spread * spread));
  if (memory.count_ < ClosestMemory::most) near &= (std::uint64_t{1} << memory.count_) - 1;
  for (; near != 0; near &= near - 1) {
    const TrianglePacket& packet =
        packed.packets[memory.packet_[static_cast<std::size_t>(std::countr_zero(near))]];
    if (&packet != search.looked_at) search.look_at(packet);
  }
}

bool TriangleTree::Impl::search_list(ClosestSearch& search, ClosestMemory& memory, int seed,
                                     const ClosestMemory* beside) const noexcept {
  if (memory.tree_ != number) {
    memory.forget();
    memory.tree_ = number;
  }
  if (memory.triangle_ >= 0) search.look_at_seed(memory.triangle_);
  if (seed >= 0 && !search.is_beside_winner()) search.look_at_seed(seed);
  const Vec3& q = search.q;
  const Vec3 step = q - memory.last_;
  memory.last_ = q;
  const double rounding_m = distance_rounding * (packed.extent_m + q.cwiseAbs().maxCoeff());
  const double near_m = std::sqrt(search.winner.at.distance2_m2);
  if (!memory.covers(q, near_m, rounding_m)) {
    if (beside != nullptr && beside->tree_ == number && beside->covers(q, near_m, rounding_m)) {
      look_through(search, *beside);
      return true;
    }
    list_packets(search, step, memory);
    if (!memory.covers(q, near_m, rounding_m)) return false;
  }
  ++memory.served_;
  look_through(search, memory);
  return true;
}

ClosestTriangle TriangleTree::closest(const Vec3& q, ClosestMemory& memory, double reach_m) const noexcept {
  const Impl& impl = *impl_;
  const PackedPart& packed = impl.packed;
  const double farthest = q.cwiseAbs().maxCoeff();
  if (packed.packets.empty() || !q.allFinite() || !(farthest <= tree_range * packed.extent_m))
    return closest(q, -1, reach_m);
  if (impl.out_of_reach(farthest, reach_m)) return {};
  ClosestSearch search(packed, impl.filter, q, reach_m);
  if (!impl.search_list(search, memory, -1, nullptr))
    impl.search_tree(search, std::sqrt(search.winner.at.distance2_m2));
  const ClosestTriangle found = search.answer();
  memory.triangle_ = found.triangle;
  return found;
}

}  // namespace fingerpad
