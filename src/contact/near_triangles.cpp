#include "contact/near_triangles.hpp"

#include <algorithm>

#include "contact/ball_shadow.hpp"
#include "contact/let_come.hpp"
#include "contact/proxy_memory_limits.hpp"
#include "contact/way_sieve.hpp"

namespace fingerpad {
namespace {

using Limits = ProxyMemoryLimits;
constexpr double longer = 1 + Limits::rounding;

bool is_box_within(const Part& part, const Vec3& q_P, double distance_m) noexcept {
  const Vec3 beyond = (q_P.cwiseAbs() - part.half_extent).cwiseMax(0.0);
  return beyond.maxCoeff() <= distance_m && beyond.norm() <= distance_m * longer;
}

}  // namespace

NearTriangles::NearTriangles(const ProxyWorld& world) {
  long triangles = 0;
  for (const int i : world.parts()) triangles += world.part(i).triangle_count();
  near_.reserve(static_cast<std::size_t>(std::min<long>(Limits::richest_view, triangles)));
  bounds_.reserve(near_.capacity());
  least_gaps_m_.reserve(near_.capacity());
  found_.reserve(near_.capacity());
  views_.resize(static_cast<std::size_t>(world.surface_count()));
}

bool NearTriangles::search(const ProxyWorld& world, const Vec3& place_O, double reach_m, int most,
                           const Blocker& blocker, Looks& looks) noexcept {
  clear();
  bool is_whole = true;
  const double distance_m = world.clearance_m() + reach_m;
  for (const int i : world.parts()) {
    PartView& view = views_[static_cast<std::size_t>(i)];
    view.first = view.end = near_.size();
    view.at_P = view.searched_P = world.in_part(i, place_O);
    view.within_reach = is_box_within(world.part(i), view.at_P, distance_m);
    if (view.within_reach && is_whole) is_whole = search_part(world, i, distance_m, most, blocker, looks);
    view.end = near_.size();
  }
  return is_whole;
}

bool NearTriangles::search_part(const ProxyWorld& world, int surface, double distance_m, int most,
                                const Blocker& blocker, Looks& looks) noexcept {
  const TriangleTree& tree = *world.surface(surface).tree;
  PartView& view = views_[static_cast<std::size_t>(surface)];
  const Part& part = tree.part();
  const SearchLimit* used = nullptr;
  auto list = [&](int triangle) {
    found_.push_back(triangle);
    let_come(part.triangles.col(triangle).data(), 3);
    let_come(part.facet_normals.col(triangle).data(), 3);
    least_gaps_m_.push_back(used->at_least_m - world.clearance_m());
  };
  found_.clear();
  bool is_whole = false;
  if (!view.is_crowded) {
    SearchLimit few{std::min(Limits::small_view, most) - count(), Limits::small_packets};
    used = &few;
    is_whole = tree.each_within(view.at_P, distance_m, few, call_with_triangle<decltype(list)>, &list);
    // How far it came that found too many depends on the order of Embree's tree.
    looks.spend(is_whole ? LookCosts::packet * few.packets : LookCosts::too_many);
    view.is_crowded = !is_whole;
    if (!is_whole) {
      found_.clear();
      least_gaps_m_.resize(near_.size());
    }
  }
  view.is_in_order = !is_whole;
  if (!is_whole) {
    SearchLimit limit{most - count(), Limits::most_packets, std::max(looks.left(), Limits::search_looks)};
    std::optional<KeptPoint> kept;
    if (blocker.surface == surface && blocker.triangle >= 0)
      kept = {approach_triangle(part, blocker.triangle, view.at_P).at.point, world.clearance_m(),
              Limits::missed_touching * world.touching_m()};
    used = &limit;
    is_whole = tree.each_within(view.at_P, distance_m, kept ? &*kept : nullptr, limit,
                                call_with_triangle<decltype(list)>, &list);
    looks.spend(limit.looks());
    view.is_crowded = !is_whole || limit.packets > Limits::few_packets;
  }
  if (!is_whole) {
    count_ = most;
    return false;
  }
  list_found(part, surface, blocker);
  count_ += static_cast<int>(found_.size());
  looks.spend((view.is_in_order ? LookCosts::listed : LookCosts::fetched) * static_cast<long>(found_.size()));
  return true;
}

/// Of many the blocker first: it is likely the worst of the next way, which then tells at once that others
/// are not.
void NearTriangles::list_found(const Part& part, int surface, const Blocker& blocker) noexcept {
  const std::size_t first = near_.size();
  for (const int triangle : found_) {
    near_.emplace_back(triangle);
    for (int k = 0; k < 3; ++k) let_come(part.vertices.col(part.triangles(k, triangle)).data(), 3);
  }
  bounds_.resize(near_.size());
  if (blocker.surface != surface || !views_[static_cast<std::size_t>(surface)].is_in_order) return;
  const auto at = std::find(found_.begin(), found_.end(), blocker.triangle);
  if (at != found_.end()) swap(first, first + static_cast<std::size_t>(at - found_.begin()));
}

/// Of a few, all are paid for when they are listed: in which order Embree finds them decides which are
/// wanted.
const NearTriangle& NearTriangles::fetched(std::size_t k, const Part& part, const PartView& view,
                                           Looks& looks) noexcept {
  NearTriangle& near = near_[k];
  if (near.fetched) return near;
  near.corners = corners_of(part, near.triangle);
  near.fetched = true;
  if (view.is_in_order) looks.spend(LookCosts::fetched);
  return near;
}

void NearTriangles::swap(std::size_t a, std::size_t b) noexcept {
  std::swap(near_[a], near_[b]);
  std::swap(bounds_[a], bounds_[b]);
  std::swap(least_gaps_m_[a], least_gaps_m_[b]);
}

void NearTriangles::look_from(const ProxyWorld& world, const Vec3& place_O) noexcept {
  for (const int i : world.parts()) {
    PartView& view = views_[static_cast<std::size_t>(i)];
    if (view.within_reach) view.at_P = world.in_part(i, place_O);
  }
}

/// False where it was last looked at from there.
bool NearTriangles::look_at(std::size_t k, const Vec3& place_P, double clearance_m) noexcept {
  NearTriangle& near = near_[k];
  if (near.seen && near.seen_from_P == place_P) return false;
  const TriangleApproach approach = approach_triangle(near.corners, place_P);
  near.seen = true;
  near.seen_from_P = place_P;
  near.first = FirstApproach(approach);
  near.gap_m = approach.distance_m - clearance_m;
  bounds_[k] = GapBound(approach, place_P, clearance_m);
  return true;
}

/// Whether the own plane of a triangle that was not looked at shows that it is no worse a wall than the
/// worst: often, and told sooner than how far it is. What the plane leaves of the gap is kept.
bool NearTriangles::is_cleared_by_plane(std::size_t k, const ProxyWorld& world, const PartWay& way,
                                        const WorstWall& worst) noexcept {
  const TriangleCorners& f = near_[k].corners;
  const double clearance_m = world.clearance_m(), tolerance_m = world.tolerance_m();
  const FacetSide facet = facet_side(f, way.from_P, way.to_P, clearance_m, tolerance_m);
  if (!is_cleared_by(facet, worst, tolerance_m)) return false;
  bounds_[k].towards = facet.side * f.normal;
  bounds_[k].level_m = -bounds_[k].towards.dot(f.a) - clearance_m - tolerance_m;
  return true;
}

bool NearTriangles::offer(const ProxyWorld& world, int surface, const Vec3& z,
                          std::span<const ProxyWall> walls, std::size_t& next, WorstWall& worst,
                          Looks& looks) noexcept {
  const PartView& view = views_[static_cast<std::size_t>(surface)];
  if (!view.within_reach) return true;
  const Part& part = world.part(surface);
  const std::size_t from = view.first + next;
  const PartWay way(world, surface, view.at_P, z);
  const PartWalls before(world, surface, walls, way.from_P);
  const double way_m = way.way_P.norm() * longer, clear_m = Limits::clear_tolerances * world.tolerance_m();
  const double nearer_m = way_m + (way.from_P - view.searched_P).norm() * longer;
  std::size_t worst_at = view.end;
  // In which order Embree finds a few decides what becomes of each.
  const long each = view.is_in_order ? 1 : LookCosts::of_few, told = view.is_in_order ? LookCosts::told : 0;
  std::size_t k = from;
  for (; k < view.end && !looks.are_spent(); ++k) {
    looks.spend(each);
    // A gap shrinks by no more than one goes: from the place that was searched from, and on the way.
    if (least_gaps_m_[k] - nearer_m > worst.slack_m) continue;
    // An earlier look left a half space free. Where the way begins and ends well in front of it, the
    // triangle cannot block; a ball that touches is nearer than that, and looks again.
    const double here_m = bounds_[k].least_gap_m(way.from_P), there_m = bounds_[k].least_gap_m(way.to_P);
    if (std::min(here_m, there_m) >= clear_m) continue;
    // The gap shrinks by no more than the way is long. Even so this breach would not be the worst.
    if (here_m - way_m > worst.slack_m) continue;
    const NearTriangle& near = fetched(k, part, view, looks);
    if (before.hide(near.corners)) continue;
    if (view.is_in_order && !near.seen && is_cleared_by_plane(k, world, way, worst)) continue;
    if (look_at(k, way.from_P, world.clearance_m())) looks.spend(told);
    const long before_it = worst.looks;
    if (worst.offer_triangle(world, way, near.corners, near.triangle, near.first)) worst_at = k;
    if (view.is_in_order) looks.spend(worst.looks - before_it);
  }
  next = k - view.first;
  // It is likely the worst of the next way too, which then tells at once that others are not.
  if (worst_at != view.end) swap(from, worst_at);
  return k == view.end;
}

double NearTriangles::room_m(const ProxyWorld& world, std::span<const ProxyWall> walls, const Vec3& centre_O,
                             double most_m, Looks& looks) noexcept {
  double room_m = most_m;
  for (const int i : world.parts()) {
    if (!(room_m > 0)) break;
    const PartView& view = views_[static_cast<std::size_t>(i)];
    if (!view.within_reach) continue;
    const Vec3 at_P = world.in_part(i, centre_O);
    const PartWalls before(world, i, walls, view.at_P);
    const double nearer_m = (at_P - view.searched_P).norm() * longer;
    for (std::size_t k = view.first; k < view.end; ++k) {
      if (least_gaps_m_[k] - nearer_m >= room_m) continue;
      if (bounds_[k].least_gap_m(at_P) >= room_m) continue;
      if (before.hide(fetched(k, world.part(i), view, looks).corners)) continue;
      look_at(k, at_P, world.clearance_m());
      room_m = std::min(room_m, near_[k].gap_m);
    }
  }
  return room_m;
}

}  // namespace fingerpad
