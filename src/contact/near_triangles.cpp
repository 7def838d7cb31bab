#include "contact/near_triangles.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "contact/packed_part.hpp"
#include "contact/proxy_memory_limits.hpp"

namespace fingerpad {
namespace {

using Limits = ProxyMemoryLimits;
constexpr double longer = 1 + Limits::rounding;

bool is_box_within(const Part& part, const Vec3& q_P, double distance_m) noexcept {
  const Vec3 beyond = (q_P.cwiseAbs() - part.half_extent).cwiseMax(0.0);
  return beyond.maxCoeff() <= distance_m && beyond.norm() <= distance_m * longer;
}

/// Takes the lane with the least value out of those that are left.
std::size_t take_least(const TrianglePacket::Lanes& values, unsigned& left) noexcept {
  auto least = static_cast<std::size_t>(std::countr_zero(left));
  for (unsigned lanes = left & (left - 1); lanes != 0; lanes &= lanes - 1) {
    const auto lane = static_cast<std::size_t>(std::countr_zero(lanes));
    if (values[lane] < values[least]) least = lane;
  }
  left &= ~(1U << least);
  return least;
}

}  // namespace

/// A way as packets of a part are held against it. Lengths scaled.
class RoughWay {
 public:
  RoughWay(const PackedPart& part, const Vec3& from_P, const Vec3& to_P, double clearance_m,
           double touched_m) noexcept
      : packed_(part),
        from_(part.scale * from_P),
        to_(part.scale * to_P),
        clearance_(part.scale * clearance_m),
        length_(no_less((to_ - from_).norm() * longer)),
        touched_(no_less(part.scale * (clearance_m + touched_m))),
        exact_margin_(static_cast<float>(2e-14 * (1 + from_.cwiseAbs().sum() + to_.cwiseAbs().sum()))) {}

  const TrianglePacket& packet(const NearPacket& near) const noexcept {
    return packed_.packets[near.of.packet];
  }

  /// @param slack_m  of the wall that is breached most so far
  WayPastPacket past(const TrianglePacket& packet, double slack_m) const noexcept {
    WayPastPacket past;
    float sum = 2 * packet.radius;
    for (int i = 0; i < 3; ++i) {
      past.from[i] = static_cast<float>(from_[i] - packet.origin[i]);
      past.to[i] = static_cast<float>(to_[i] - packet.origin[i]);
      sum += std::max(std::abs(past.from[i]), std::abs(past.to[i]));
    }
    past.margin = (rough_margin * sum + exact_margin_) * (1 + 0x1p-20F);
    past.touched = touched_ + past.margin;
    past.ends = end(slack_m) + past.margin;
    past.begins = past.ends + length_;
    constexpr float turn_per_margin = 8;  // twice what a unit vector turns by, and as much to spare
    past.turn = turn_per_margin * past.margin * length_;
    return past;
  }

  /// Where a way that breaches a wall by so much ends.
  float end(double slack_m) const noexcept { return no_less(clearance_ + packed_.scale * slack_m); }

  /// How far a packet's triangles may reach from its origin along a wall's normal and stay behind the wall.
  float behind(const PartWalls::PartWall& wall, const TrianglePacket& packet) const noexcept {
    const float margin = 2 * rough_margin * packet.radius + exact_margin_;
    return -no_less(static_cast<double>(margin) - packed_.scale * wall.offset_m +
                    wall.normal_P.dot(packet.origin));
  }

 private:
  /// Whatever rounding to float does, twice.
  static float no_less(double distance) noexcept {
    return static_cast<float>(distance + 0x1p-22 * std::abs(distance));
  }

  const PackedPart& packed_;
  Vec3 from_, to_;
  double clearance_;
  float length_, touched_;
  float exact_margin_;  // the last term of rough_margin's claim
};

NearTriangles::NearTriangles(const ProxyWorld& world) {
  std::size_t packets = 0;
  for (int i = 0; i < world.surface_count(); ++i) {
    if (!world.is_plane(i)) packets += world.surface(i).tree->packed().packets.size();
  }
  // A packet more than is asked for tells that there are more.
  near_.reserve(std::min<std::size_t>(Limits::richest_view, packets) + 1);
  found_.reserve(near_.capacity());
  views_.resize(static_cast<std::size_t>(world.surface_count()));
}

bool NearTriangles::search(const ProxyWorld& world, const Vec3& place_O, double reach_m, int most,
                           Looks& looks) noexcept {
  clear();
  bool is_whole = true;
  const double distance_m = world.clearance_m() + reach_m;
  for (int i = 0; i < world.surface_count(); ++i) {
    PartView& view = views_[static_cast<std::size_t>(i)];
    view.first = view.end = near_.size();
    if (world.is_plane(i)) continue;
    view.at_P = world.in_part(i, place_O);
    view.within_reach = is_box_within(world.part(i), view.at_P, distance_m);
    if (view.within_reach && is_whole) is_whole = search_part(world, i, distance_m, most, looks);
    view.end = near_.size();
  }
  return is_whole;
}

bool NearTriangles::search_part(const ProxyWorld& world, int surface, double distance_m, int most,
                                Looks& looks) noexcept {
  const TriangleTree& tree = *world.surface(surface).tree;
  found_.clear();
  SearchLimit limit{most - count(), std::min(Limits::most_packets, Limits::packets_a_triangle * most)};
  const bool is_whole =
      tree.each_within(views_[static_cast<std::size_t>(surface)].at_P, distance_m, limit, found_);
  // How far a search came that found too many depends on the order of Embree's tree; mostly it found more
  // than two in a packet.
  looks.spend(LookCosts::search + LookCosts::packet * (is_whole ? limit.packets : limit.most_triangles / 2));
  count_ += limit.triangles;
  if (!is_whole) return false;
  // What a pass costs depends on the order, too.
  std::sort(found_.begin(), found_.end(),
            [](const PacketLanes& a, const PacketLanes& b) { return a.packet < b.packet; });
  for (const PacketLanes& of : found_) near_.emplace_back().of = of;
  return true;
}

void NearTriangles::look_from(const ProxyWorld& world, const Vec3& place_O) noexcept {
  for (int i = 0; i < world.surface_count(); ++i) {
    PartView& view = views_[static_cast<std::size_t>(i)];
    if (view.within_reach) view.at_P = world.in_part(i, place_O);
  }
}

/// The triangles of a packet that may be in the way and in front of the walls, as bits; near.ends tells where
/// the way ends before them.
unsigned NearTriangles::lanes_left(const RoughWay& way, const PartWalls& before, double slack_m,
                                   NearPacket& near, Looks& looks) const noexcept {
  const TrianglePacket& packet = way.packet(near);
  const WayPastPacket past = way.past(packet, slack_m);
  const std::array<float, 3> here{past.from[0], past.from[1], past.from[2]};
  looks.spend(LookCosts::held);
  unsigned lanes = near.of.lanes;
  if (!near.is_seen || near.seen_from != here) {
    if (near.is_seen) {
      WayPastPacket seen_from_elsewhere = past;
      seen_from_elsewhere.ends = std::numeric_limits<float>::infinity();
      lanes &= may_block_(near.tangents, seen_from_elsewhere, near.ends) | packet.always_exact;
      if (lanes == 0) return 0;
    }
    looks.spend(LookCosts::tangents);
    make_tangents_(packet, past.from, near.tangents);
    near.seen_from = here;
    near.is_seen = true;
  }
  lanes &= may_block_(near.tangents, past, near.ends) | packet.always_exact;
  return lanes == 0 ? 0 : lanes_in_front(way, before, packet, lanes, looks);
}

unsigned NearTriangles::lanes_in_front(const RoughWay& way, const PartWalls& walls,
                                       const TrianglePacket& packet, unsigned lanes,
                                       Looks& looks) const noexcept {
  for (const PartWalls::PartWall& wall : walls.walls()) {
    looks.spend(LookCosts::held);
    const float along[3] = {static_cast<float>(wall.normal_P[0]), static_cast<float>(wall.normal_P[1]),
                            static_cast<float>(wall.normal_P[2])};
    lanes &= ~reach_within_(packet, along, way.behind(wall, packet));
  }
  return lanes;
}

/// Of the lanes left before, those past which the way is not seen to be free or to be breached less.
unsigned NearTriangles::lanes_swept(const WayPastPacket& past, const TrianglePacket& packet, unsigned lanes,
                                    NearPacket& near, Looks& looks) const noexcept {
  unsigned breaching = 0;
  for (unsigned left = lanes; left != 0; left &= left - 1) {
    const auto lane = static_cast<std::size_t>(std::countr_zero(left));
    breaching |= static_cast<unsigned>(near.ends[lane] <= past.ends) << lane;
  }
  lanes &= breaching | packet.always_exact;
  if ((lanes & ~static_cast<unsigned>(packet.always_exact)) == 0) return lanes;
  looks.spend(LookCosts::swept);
  return lanes & (may_block_swept_(packet, near.tangents, past, near.ends) | packet.always_exact);
}

/// Brings those packets to the front that may be in the way, the one that is likely to block most first: what
/// comes after it is then mostly told to block less.
void NearTriangles::bring_first(const RoughWay& way, const PartWalls& before, double slack_m, PartView& view,
                                Looks& looks) noexcept {
  view.compared = std::min(view.end, view.first + Limits::most_compared);
  view.left = view.first;
  float least = std::numeric_limits<float>::infinity();
  std::size_t first = view.first;
  for (std::size_t k = view.first; k < view.compared; ++k) {
    NearPacket& near = near_[k];
    near.left = lanes_left(way, before, slack_m, near, looks);
    if (near.left == 0) continue;
    unsigned lanes = near.left;
    const float ends = near.ends[take_least(near.ends, lanes)];
    if (ends < least) {
      least = ends;
      first = view.left;
    }
    if (k != view.left) std::swap(near, near_[view.left]);
    ++view.left;
  }
  if (first != view.first) std::swap(near_[view.first], near_[first]);
}

bool NearTriangles::offer(const ProxyWorld& world, int surface, const Vec3& z,
                          std::span<const ProxyWall> walls, std::size_t& next, WorstWall& worst,
                          Looks& looks) noexcept {
  PartView& view = views_[static_cast<std::size_t>(surface)];
  if (!view.within_reach) return true;
  const PackedPart& packed = world.surface(surface).tree->packed();
  const PartWay way(world, surface, view.at_P, z);
  const PartWalls before(world, surface, walls, way.from_P);
  const RoughWay rough(packed, way.from_P, way.to_P, world.clearance_m(), 2 * world.tolerance_m());
  if (next == 0) bring_first(rough, before, worst.slack_m, view, looks);
  std::size_t k = view.first + next;
  // At least one, so that it comes to its end however little a tick may look at.
  for (bool is_first = true;; ++k, is_first = false) {
    if (k == view.left) k = view.compared;
    if (k == view.end || (looks.are_spent() && !is_first)) break;
    NearPacket& near = near_[k];
    const TrianglePacket& packet = rough.packet(near);
    unsigned lanes = k < view.compared ? near.left : lanes_left(rough, before, worst.slack_m, near, looks);
    if (lanes == 0) continue;
    if (near.told == 0 || near.told_from_P != way.from_P)
      lanes = lanes_swept(rough.past(packet, worst.slack_m), packet, lanes, near, looks);
    while (lanes != 0) {
      const std::size_t lane = take_least(near.ends, lanes);
      const bool is_rough = (packet.always_exact >> lane & 1) == 0;
      if (is_rough && near.ends[lane] > rough.past(packet, worst.slack_m).ends) continue;
      const int triangle = packet.exact[lane].triangle;
      if (near.told_from_P != way.from_P) near.told = 0;
      TriangleApproach& first = near.approaches[lane];
      looks.spend(1);
      if ((near.told >> lane & 1) != 0 &&
          first.distance_m - world.clearance_m() + first.towards.dot(way.way_P) > worst.slack_m)
        continue;
      const TriangleCorners corners = corners_of(*packed.part, triangle);
      looks.spend(LookCosts::fetched);
      if (before.hide(corners)) continue;
      if ((near.told >> lane & 1) == 0) first = approach_triangle(corners, way.from_P);
      near.told |= 1U << lane;
      near.told_from_P = way.from_P;
      const int sweeps = worst.sweeps;
      worst.offer_triangle(world, way, corners, triangle, first);
      looks.spend(LookCosts::sweep * (worst.sweeps - sweeps));
    }
  }
  next = k - view.first;
  return k == view.end;
}

double NearTriangles::room_m(const ProxyWorld& world, std::span<const ProxyWall> walls, const Vec3& centre_O,
                             double most_m, Looks& looks) noexcept {
  double room_m = most_m;
  for (int i = 0; i < world.surface_count(); ++i) {
    PartView& view = views_[static_cast<std::size_t>(i)];
    if (!view.within_reach || !(room_m > 0)) continue;
    const PackedPart& packed = world.surface(i).tree->packed();
    const Vec3 at_P = world.in_part(i, centre_O);
    const PartWalls before(world, i, walls, view.at_P);
    bring_first(RoughWay(packed, at_P, at_P, world.clearance_m(), room_m), before, room_m, view, looks);
    for (std::size_t k = view.first; room_m > 0; ++k) {
      if (k == view.left) k = view.compared;
      if (k == view.end) break;
      const RoughWay rough(packed, at_P, at_P, world.clearance_m(), room_m);
      NearPacket& near = near_[k];
      const TrianglePacket& packet = rough.packet(near);
      unsigned lanes = k < view.compared ? near.left : lanes_left(rough, before, room_m, near, looks);
      while (lanes != 0) {
        const std::size_t lane = take_least(near.ends, lanes);
        const bool is_rough = (packet.always_exact >> lane & 1) == 0;
        if (is_rough && near.ends[lane] > rough.past(packet, room_m).ends) continue;
        const TriangleCorners corners = corners_of(*packed.part, packet.exact[lane].triangle);
        looks.spend(LookCosts::fetched);
        if (before.hide(corners)) continue;
        room_m = std::min(room_m, approach_triangle(corners, at_P).distance_m - world.clearance_m());
      }
      if (looks.are_spent()) return 0;
    }
  }
  return room_m;
}

}  // namespace fingerpad
