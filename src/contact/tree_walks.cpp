#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "contact/ball_shadow.hpp"
#include "contact/nearest_packets.hpp"
#include "contact/tree_parts.hpp"
#include "contact/within_search.hpp"

// Searches of a tree that are bounded: up to a limit, or in pieces.

namespace fingerpad {
namespace {

/// Packets, the likeliest first, that are looked at for a triangle to begin with.
constexpr int seed_packets = 8;

struct LimitedSearch : WithinSearch {
  SearchLimit* limit;
  void (*visit)(void* context, int triangle);
  void* visit_context;
};

void count_triangle(void* any_search, int triangle) {
  const LimitedSearch& search = *static_cast<LimitedSearch*>(any_search);
  if (++search.limit->triangles > search.limit->most_triangles) return;
  search.visit(search.visit_context, triangle);
}

/// A search among what a shadow leaves.
struct ShadowedSearch : LimitedSearch {
  std::optional<BallShadow> shadow;
};

void count_lit_triangle(void* any_search, int triangle) {
  const ShadowedSearch& search = *static_cast<ShadowedSearch*>(any_search);
  if (search.shadow) {
    const Part& part = *search.packed->part;
    std::array<Vec3, 3> corners;
    for (int k = 0; k < 3; ++k)
      corners[static_cast<std::size_t>(k)] =
          search.packed->scale * part.vertices.col(part.triangles(k, triangle));
    ++search.limit->shadowed;
    if (search.shadow->covers(corners)) return;
  }
  // A search for a few does without: it costs more than they do.
  search.limit->at_least_m = search.at_least_m();
  count_triangle(any_search, triangle);
}

/// Passes triangles on and counts them.
struct Counting {
  void (*visit)(void* context, int triangle);
  void* context;
  long count = 0;
};

void count_and_visit(void* any_counting, int triangle) {
  Counting& counting = *static_cast<Counting*>(any_counting);
  ++counting.count;
  counting.visit(counting.context, triangle);
}

/// Whether a packet's box comes within the radius of a point, or of a box of such half sides about it; all
/// scaled. Narrower than Embree's own test of
/// the padded box, so that it alone decides, on every machine alike.
bool is_box_near(const TrianglePacket& packet, const Vec3& at, double radius,
                 const Vec3& half = Vec3::Zero()) noexcept {
  constexpr double rounding = 1e-12;
  double beyond2 = 0;
  for (int i = 0; i < 3; ++i) {
    const double beyond =
        std::abs(at[i] - packet.origin[i]) - static_cast<double>(packet.box_half[i]) - half[i] - rounding;
    if (beyond > 0) beyond2 += beyond * beyond;
  }
  const double grown = radius * (1 + rounding);
  return beyond2 <= grown * grown;
}

float visit_limited(void* any_search, unsigned index, float radius) noexcept {
  const LimitedSearch& search = *static_cast<const LimitedSearch*>(any_search);
  const PackedPart& packed = *search.packed;
  if (search.limit->is_exceeded()) return 0;
  if (!is_box_near(packed.packets[index], search.scaled, search.bound_m * packed.scale)) return radius;
  ++search.limit->packets;
  search.look_at(packed.packets[index]);
  return search.limit->is_exceeded() ? 0 : radius;
}

}  // namespace

bool TriangleTree::each_within(const Vec3& q, double reach_m, SearchLimit& limit,
                               void (*visit)(void* context, int triangle), void* context) const noexcept {
  const Impl& impl = *impl_;
  const PackedPart& packed = impl.packed;
  limit.packet_price = impl.packet_price();
  const double farthest = q.cwiseAbs().maxCoeff();
  if (packed.packets.empty() || !q.allFinite() || !(reach_m >= 0)) return true;
  if (impl.out_of_reach(farthest, reach_m)) return true;
  LimitedSearch search{{packed, impl.filter, q, reach_m, count_triangle, nullptr}, &limit, visit, context};
  search.context = &search;
  if (farthest > tree_range * packed.extent_m) {
    limit.packets += static_cast<int>(packed.packets.size());
    if (!limit.is_exceeded()) impl.far_each_within(q, reach_m, count_triangle, &search);
  } else {
    impl.scene.each_near(search.embree, search.radius(search.bound_m), visit_limited, &search);
  }
  return !limit.is_exceeded();
}

bool TriangleTree::each_within(const Vec3& q, double reach_m, const KeptPoint* kept, SearchLimit& limit,
                               void (*visit)(void* context, int triangle), void* context) const noexcept {
  const Impl& impl = *impl_;
  const PackedPart& packed = impl.packed;
  const double farthest = q.cwiseAbs().maxCoeff();
  if (packed.packets.empty() || !q.allFinite() || !(reach_m >= 0)) return true;
  if (impl.out_of_reach(farthest, reach_m)) return true;
  if (farthest > tree_range * packed.extent_m) return each_within(q, reach_m, limit, visit, context);
  limit.packet_price = impl.packet_price();
  ShadowedSearch search{
      {{packed, impl.filter, q, reach_m, count_lit_triangle, nullptr}, &limit, visit, context}, std::nullopt};
  search.context = &search;
  if (kept != nullptr && BallShadow::is_cast(q, reach_m - kept->clearance_m, *kept))
    search.shadow.emplace(q, reach_m - kept->clearance_m, *kept, packed.scale);
  const double radius = search.bound_m * packed.scale;
  const double grown = radius * (1 + 1e-12);
  WindingNumber::NearPackets near(impl.winding, search.scaled, radius);
  std::size_t index = 0;
  const long tests = limit.tests;
  while (!limit.is_exceeded() && near.next(index)) {
    if (packed.discs[index].least_distance(search.scaled) > grown) {
      ++limit.passed_over;
      continue;
    }
    const TrianglePacket& packet = packed.packets[index];
    if (!is_box_near(packet, search.scaled, radius)) continue;
    ++limit.packets;
    limit.tests = tests + near.tests();
    if (!search.shadow || !search.shadow->covers(packet)) search.look_at(packet);
  }
  limit.tests = tests + near.tests();
  return !limit.is_exceeded();
}

bool TriangleTree::each_beside(const Vec3& q, const Vec3& way, double reach_m, std::size_t& next,
                               Looks& looks, const PacketSieve* sieve,
                               void (*visit)(void* context, int triangle), void* context) const noexcept {
  const Impl& impl = *impl_;
  const PackedPart& packed = impl.packed;
  // From the middle of the way to its ends it is no farther than half its length.
  const Vec3 middle = q + 0.5 * way;
  constexpr double longer = 1 + 1e-12;
  const double around_m = reach_m + 0.5 * way.norm() * longer;
  const double farthest = middle.cwiseAbs().maxCoeff();
  if (packed.packets.empty() || !middle.allFinite() || !(reach_m >= 0)) return true;
  if (impl.out_of_reach(farthest, around_m)) return true;
  const bool is_far = farthest > tree_range * packed.extent_m;
  Counting counting{visit, context};
  const WithinSearch search(packed, impl.filter, middle, around_m, count_and_visit, &counting);
  const double radius = std::min(search.bound_m, reach_m) * packed.scale;
  const Vec3 half = 0.5 * packed.scale * way, half_box = half.cwiseAbs();
  using Near = WindingNumber::NearPackets;
  Near near(impl.winding, search.scaled, radius, half, Near::About::way, next);
  const long packet_price = impl.packet_price();
  for (long paid = 0; !looks.are_spent();) {
    std::size_t index = packed.packets.size();
    const bool is_found = near.next(index);
    looks.spend(LookCosts::beside * (near.tests() - std::exchange(paid, near.tests())));
    next = index + 1;
    if (!is_found) return true;
    if (sieve != nullptr && sieve->passes_over(sieve->context, packed.discs[index])) {
      looks.spend(LookCosts::passed_over);
      continue;
    }
    const TrianglePacket& packet = packed.packets[index];
    looks.spend(packet_price);
    if (is_far) {
      search.look_from_afar_at(packet);
    } else if (!is_box_near(packet, search.scaled, radius, half_box)) {
      continue;
    } else if (sieve != nullptr) {
      looks.spend(LookCosts::sieved + sieve->further_looks);
      for (unsigned lanes = sieve->lanes_left(sieve->context, packet); lanes != 0; lanes &= lanes - 1)
        count_and_visit(&counting, packet.exact[static_cast<std::size_t>(std::countr_zero(lanes))].triangle);
    } else {
      search.look_at(packet);
    }
    looks.spend(std::exchange(counting.count, 0));
  }
  return false;
}

std::optional<ClosestTriangle> TriangleTree::closest(const Vec3& q, double reach_m, ClosestWalk& walk,
                                                     Looks& looks) const noexcept {
  const Impl& impl = *impl_;
  const PackedPart& packed = impl.packed;
  const double farthest = q.cwiseAbs().maxCoeff();
  if (packed.packets.empty() || !q.allFinite() || !(farthest <= tree_range * packed.extent_m))
    return closest(q, -1, reach_m);
  if (impl.out_of_reach(farthest, reach_m)) return ClosestTriangle{};
  ClosestSearch search(packed, impl.filter, q, reach_m);
  const int count = static_cast<int>(packed.slot_of.size());
  if (walk.triangle < 0 || walk.triangle >= count) {
    // Near the answer, so that it is about right wherever it is broken off.
    walk.triangle =
        about_closest(q, -1, std::numeric_limits<double>::infinity(), seed_packets, looks).triangle;
    if (walk.triangle < 0)
      walk.triangle = packed.packets[impl.winding.some_near(search.scaled)].exact[0].triangle;
  }
  search.look_at_seed(walk.triangle);
  const TrianglePacket* const seen = search.looked_at;
  const auto radius_left = [&] {
    return std::min(std::sqrt(search.winner.at.distance2_m2) * packed.scale, static_cast<double>(far_off));
  };
  WindingNumber::NearPackets near(impl.winding, search.scaled, radius_left(), Vec3::Zero(),
                                  WindingNumber::NearPackets::About::box, walk.next);
  for (long paid = 0; !looks.are_spent();) {
    const double radius = radius_left();
    near.shrink(radius);
    std::size_t index = packed.packets.size();
    const bool is_found = near.next(index);
    looks.spend(LookCosts::cluster * (near.tests() - std::exchange(paid, near.tests())));
    walk.next = index + 1;
    if (!is_found) {
      const ClosestTriangle answer = search.answer();
      if (answer.triangle >= 0) walk.triangle = answer.triangle;
      return answer;
    }
    const TrianglePacket& packet = packed.packets[index];
    if (&packet == seen || !is_box_near(packet, search.scaled, radius)) continue;
    search.look_at(packet);
    looks.spend(LookCosts::closest);
  }
  if (search.won_in != nullptr) walk.triangle = search.winner.triangle;
  return std::nullopt;
}

std::optional<bool> TriangleTree::encloses(const Vec3& q, WindingWalk& walk, Looks& looks) const noexcept {
  const PackedPart& packed = impl_->packed;
  if (!q.allFinite() || q.cwiseAbs().maxCoeff() > tree_range * packed.extent_m) return false;
  return impl_->winding.encloses(packed, q, walk, looks);
}

ClosestTriangle TriangleTree::closest(const Vec3& q, BriefSearch& brief, double reach_m) const noexcept {
  brief.spent = 0;
  brief.broken_off = false;
  ClosestMemory* const memory = brief.memory;
  if (memory != nullptr && impl_->is_searched(q, reach_m)) {
    ClosestSearch search(impl_->packed, impl_->filter, q, reach_m);
    const bool listed = impl_->search_list(search, *memory, brief.triangle, brief.beside);
    // The walk is to begin no farther off than without a memory: it may be broken off.
    if (!listed && brief.triangle >= 0) search.look_at_seed(brief.triangle);
    if (search.won_in != nullptr) {
      brief.triangle = search.winner.triangle;
      memory->slot_ = search.won_slot();
    }
    if (listed) return search.answer();
  }
  ClosestWalk walk{brief.triangle, 0};
  Looks looks(brief.most_looks);
  const auto found = closest(q, reach_m, walk, looks);
  brief.spent = looks.spent();
  brief.broken_off = !found;
  const ClosestTriangle nearest =
      found ? *found : ClosestTriangle{walk.triangle, closest_on_triangle(part(), walk.triangle, q)};
  brief.triangle = nearest.triangle;
  if (memory != nullptr && nearest.triangle >= 0)
    memory->slot_ = impl_->packed.slot_of[static_cast<std::size_t>(nearest.triangle)];
  return nearest.at.distance2_m2 <= reach_m * reach_m ? nearest : ClosestTriangle{};
}

}  // namespace fingerpad
