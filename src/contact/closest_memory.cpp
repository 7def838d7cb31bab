#include "contact/closest_memory.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "contact/closest_search.hpp"
#include "contact/let_come.hpp"
#include "contact/packet_gathering.hpp"
#include "contact/tree_parts.hpp"

namespace fingerpad {
namespace {

/// A list is made for so many steps of the path, and not where it would serve fewer than `least_steps`.
constexpr double steps_ahead = 24, least_steps = 6;
/// In radii of the packet that holds the closest triangle: how long a way a list serves at least and at most.
constexpr double least_way = 1, longest_way = 5;
/// Where nothing is within reach, it serves more steps, as nothing need be looked at.
constexpr double free_steps_ahead = 200;
/// How the room beside the way changes: a path that left it sideways is given more, one that came to its end
/// less.
constexpr double wider = 1.5, narrower = 0.8;
/// And where a list did not pay at all: the path goes to and fro.
constexpr double much_wider = 4;
/// Where more stands near the way than a list holds, the next is for half of it, down to this share, and
/// longer again slowly.
constexpr double least_share = 0.25, share_growth = 1.1;
/// A path that turned by more than this [rad] since the last list has turned back, or trembles: it is taken
/// to go straight on.
constexpr double most_turn = 0.5;
/// Queries without a list after one that did not pay.
constexpr int pause_queries = 64;
/// Of clusters: a gathering that takes more is given up.
constexpr long most_tests = 400;
/// Rounding of a distance between two points, in sizes of the part.
constexpr double distance_rounding = 1e-12;

/// The way that the path goes along the surface, at most of length 1; nothing where it has only begun.
Vec3 forward(const ClosestSearch& search, const Vec3& step, double near_m) noexcept {
  const double step_m = step.norm();
  if (!(step_m > 0 && step_m < std::numeric_limits<double>::infinity())) return Vec3::Zero();
  const Vec3 way = step / step_m;
  if (!(near_m > 0)) return way;
  const Vec3 off = (search.q - search.winner.at.point) / near_m;
  return way - way.dot(off) * off;
}

/// Whether what a path asks of a part besides its triangles is there: normals and neighbours.
bool is_whole(const Part& part) noexcept {
  return part.corner_normals.cols() == Eigen::Index{3} * part.triangle_count();
}

/// Lets the corners of packets come, once they have come themselves. (Inlined: see let_come.hpp.)
[[gnu::always_inline]] inline void let_corners_come(const PackedPart& packed, const PacketList& list,
                                                    std::uint64_t soon) noexcept {
  for (; soon != 0; soon &= soon - 1) {
    const TrianglePacket& packet =
        packed.packets[list.packet[static_cast<std::size_t>(std::countr_zero(soon))]];
    for (const TrianglePacket::Exact& exact : packet.exact) {
      for (const std::int32_t vertex : exact.vertex)
        __builtin_prefetch(packed.part->vertices.col(vertex).data(), 0, 2);
    }
  }
}

}  // namespace

/// Lists what stands around the way to come, if that pays. Costs no more than `most_tests` and as many
/// packets.
/// @param search    has looked at its seed
/// @param step      how far the path went since the last query, and which way [m]
void TriangleTree::Impl::list_packets(const ClosestSearch& search, const Vec3& step,
                                      ClosestMemory& memory) const noexcept {
  const bool poor = memory.list().is_list() && memory.served_ < least_steps;
  if (!poor) memory.learn_room(search.q);
  memory.take_next_list();
  PacketList& list = memory.list();
  if (poor && memory.room_ >= ClosestMemory::greatest_room) memory.pause_ = pause_queries;
  if (poor) memory.room_ = std::min(memory.room_ * much_wider, ClosestMemory::greatest_room);
  if (memory.pause_ > 0) {
    --memory.pause_;
    return;
  }
  const double step_m = step.norm();
  const double near_m = std::sqrt(search.winner.at.distance2_m2);  // the reach where there is none
  PathPiece way{search.q, Vec3::Zero()};
  double way_m = std::max(free_steps_ahead * step_m, near_m / 8), beside_m = way_m;
  if (search.won_in != nullptr) {
    const double radius_m = static_cast<double>(search.won_in->radius) / packed.scale;
    way_m = memory.share_ * std::clamp(steps_ahead * step_m, least_way * radius_m, longest_way * radius_m);
    beside_m = memory.room_ * way_m;
    way = memory.way_ahead(search.q, forward(search, step, near_m), way_m);
  }
  // It must hold the ball of this query, and those of some of the next.
  const double held_m = near_m + (search.q - way.middle + way.half).norm(),
               least = (held_m + beside_m / 4) * packed.scale,
               within = least + beside_m * 0.75 * packed.scale;
  if (!(way_m >= least_steps * step_m) || !(within < static_cast<double>(far_off))) return;

  PacketGathering gathering;
  const PathPiece scaled{way.middle * packed.scale, way.half * packed.scale};
  WindingNumber::NearPackets near(winding, scaled.middle, within, scaled.half);
  for (std::size_t next = 0; !gathering.is_full() && near.tests() <= most_tests && near.next(next);)
    gathering.add(static_cast<std::uint32_t>(next));
  double clear = 0;
  if (!gathering.is_full() && near.tests() <= most_tests) {
    if (gathering.count > 0) disc_measure(packed.discs.data(), scaled, gathering);
    const Vec3 anchor(search.embree[0], search.embree[1], search.embree[2]);
    clear = put_into(list, packed.discs.data(), anchor, within, gathering);
  }
  const bool fits = clear > least;
  if (!fits) {
    list.clear();
    // Perhaps a shorter one is not too much.
    if (!(memory.share_ > least_share)) memory.pause_ = pause_queries;
    memory.share_ = std::max(memory.share_ / 2, least_share);
    memory.room_ = std::max(memory.room_ / 2, ClosestMemory::least_room);
    return;
  }
  memory.share_ = std::min(memory.share_ * share_growth, 1.0);
  list.clear_m = clear / packed.scale * (1 - distance_rounding);
  list.middle = way.middle;
  list.half = way.half;
  const double half2 = way.half.squaredNorm();
  list.per_half2 = half2 > 0 ? 1 / half2 : 0;
  memory.served_ = 0;
  if (is_cold()) memory.soon_ = let_packets_come(list, gathering, near_m * packed.scale);
}

/// Lets the packets come that will be looked at on the way; returns which these are.
/// @param gathering  of the list's packets
/// @param near       how near the closest triangle is, scaled
std::uint64_t TriangleTree::Impl::let_packets_come(const PacketList& list, const PacketGathering& gathering,
                                                   double near) const noexcept {
  constexpr double somewhat_more = 1.01;
  std::uint64_t soon = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(list.count); ++i) {
    if (!(gathering.distance2[i] <= near * near * somewhat_more)) continue;
    soon |= std::uint64_t{1} << i;
    const auto* bytes = reinterpret_cast<const char*>(&packed.packets[list.packet[i]]);
    for (std::size_t line = 0; line < sizeof(TrianglePacket); line += 64)
      __builtin_prefetch(bytes + line, 0, 2);
  }
  return soon;
}

/// Gives the way ahead more room beside it or less, by where the path left that of the last list.
void ClosestMemory::learn_room(const Vec3& q) noexcept {
  if (!(list().per_half2 > 0) || !list().is_list()) return;
  const double along = list().along(q);
  if (along < 0.5) room_ = std::min(room_ * wider, greatest_room);
  if (along >= 1) room_ = std::max(room_ * narrower, least_room);
}

/// The chord of the way ahead, if this bends on as it has bent since the last list, moved halfway to the arc.
/// @param heading  at most of length 1
PathPiece ClosestMemory::way_ahead(const Vec3& q, const Vec3& heading, double way_m) noexcept {
  const double since_m = (q - from_).norm();
  Vec3 bend = Vec3::Zero();
  if (since_m > way_m / 4 && since_m < 2 * way_m &&
      (heading - heading_).squaredNorm() < most_turn * most_turn)
    bend = (heading - heading_) / since_m;
  from_ = q;
  heading_ = heading;
  const Vec3 half = way_m / 2 * heading + way_m * way_m / 4 * bend;
  return {q + half - way_m * way_m / 16 * bend, half};
}

/// Looks at the packets listed that could hold something nearer.
void TriangleTree::Impl::look_through(ClosestSearch& search, const PacketList& list) const noexcept {
  float at[3], spread = list.spread;
  for (int i = 0; i < 3; ++i) {
    at[i] = static_cast<float>(search.scaled[i] - list.anchor[i]);
    spread += std::abs(at[i]);
  }
  const float limit = search.best + disc_margin * spread + search.exact_margin;
  const int groups = (list.count + packet_width - 1) / packet_width;
  std::uint64_t near = disc_filter(list.discs.data(), groups, at, limit, disc_margin * (spread * spread));
  if (list.count < PacketList::most) near &= (std::uint64_t{1} << list.count) - 1;
  for (; near != 0; near &= near - 1) {
    const TrianglePacket& packet =
        packed.packets[list.packet[static_cast<std::size_t>(std::countr_zero(near))]];
    if (&packet != search.looked_at) search.look_at(packet);
  }
}

bool TriangleTree::Impl::search_list(ClosestSearch& search, ClosestMemory& memory, int seed,
                                     const ClosestMemory* beside) const noexcept {
  if (memory.tree_ != number) {
    memory.forget();
    memory.tree_ = number;
  }
  if (memory.slot_ != ClosestMemory::no_slot) search.look_at_slot(memory.slot_);
  if (seed >= 0 && !search.is_beside_winner()) search.look_at_seed(seed);
  const Vec3& q = search.q;
  const Vec3 step = q - memory.last_;
  memory.last_ = q;
  if (memory.soon_ != 0) let_corners_come(packed, memory.list(), std::exchange(memory.soon_, 0));
  const double rounding_m = distance_rounding * (packed.extent_m + q.cwiseAbs().maxCoeff());
  const auto within_m = [&] { return std::sqrt(search.winner.at.distance2_m2) + rounding_m; };
  const PacketList* list = memory.covering(q, within_m());
  if (list == nullptr && beside != nullptr && beside->tree_ == number) {
    // What is near may stand in it though the seed is far off.
    const PacketList* near = beside->covering(q, 0);
    if (near != nullptr) look_through(search, *near);
    if (near != nullptr && near->covers(q, within_m())) return true;
  }
  if (list == nullptr) {
    list_packets(search, step, memory);
    if (!memory.list().covers(q, within_m())) return false;
    list = &memory.list();
  }
  ++memory.served_;
  look_through(search, *list);
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
  if (memory.is_new_ && memory.tree_ == impl.number) {
    const std::uint32_t slot = memory.slot_;
    let_come_around(*packed.part, packed.packets[slot / packet_width].exact[slot % packet_width].triangle);
    memory.is_new_ = false;
  }
  if (!impl.search_list(search, memory, -1, nullptr))
    impl.search_tree(search, std::sqrt(search.winner.at.distance2_m2));
  const ClosestTriangle found = search.answer();
  const std::uint32_t slot = search.won_in != nullptr ? search.won_slot() : ClosestMemory::no_slot;
  memory.is_new_ = impl.is_cold() && slot != memory.slot_ && found.triangle >= 0 && is_whole(*packed.part);
  if (memory.is_new_) let_come(*packed.part, found.triangle, found.at.feature);
  memory.slot_ = slot;
  return found;
}

}  // namespace fingerpad
