#include "contact/near_triangles.hpp"

#include <algorithm>

#include "contact/ball_shadow.hpp"
#include "contact/proxy_memory_limits.hpp"

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
  for (int i = 0; i < world.surface_count(); ++i) {
    if (!world.is_plane(i)) triangles += world.part(i).triangle_count();
  }
  near_.reserve(static_cast<std::size_t>(std::min<long>(Limits::richest_view, triangles)));
  found_.reserve(near_.capacity());
  views_.resize(static_cast<std::size_t>(world.surface_count()));
}

bool NearTriangles::search(const ProxyWorld& world, const Vec3& place_O, double reach_m, int most,
                           const Blocker& blocker, Looks& looks) noexcept {
  clear();
  bool is_whole = true;
  const double distance_m = world.clearance_m() + reach_m;
  for (int i = 0; i < world.surface_count(); ++i) {
    PartView& view = views_[static_cast<std::size_t>(i)];
    view.first = view.end = near_.size();
    if (world.is_plane(i)) continue;
    view.at_P = world.in_part(i, place_O);
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
  const auto list = [](void* found, int triangle) {
    static_cast<std::vector<int>*>(found)->push_back(triangle);
  };
  found_.clear();
  bool is_whole = false;
  if (!view.is_crowded) {
    SearchLimit few{std::min(Limits::small_view, most) - count(), Limits::small_packets};
    is_whole = tree.each_within(view.at_P, distance_m, few, list, &found_);
    // How far it came that found too many depends on the order of Embree's tree.
    looks.spend(is_whole ? LookCosts::packet * few.packets : LookCosts::too_many);
    view.is_crowded = !is_whole;
    if (!is_whole) found_.clear();
  }
  view.is_in_order = !is_whole;
  if (!is_whole) {
    SearchLimit limit{most - count(), Limits::most_packets};
    std::optional<KeptPoint> kept;
    if (blocker.surface == surface && blocker.triangle >= 0)
      kept = {approach_triangle(tree.part(), blocker.triangle, view.at_P).at.point, world.clearance_m(),
              2 * world.touching_m()};
    is_whole = tree.each_within(view.at_P, distance_m, kept ? &*kept : nullptr, limit, list, &found_);
    looks.spend(limit.tests + LookCosts::packet * limit.packets + LookCosts::shadowed * limit.shadowed);
    view.is_crowded = !is_whole || limit.packets > Limits::small_packets / 4;
  }
  if (!is_whole) {
    count_ = most;
    return false;
  }
  for (const int triangle : found_) {
    NearTriangle& near = near_.emplace_back();
    near.triangle = triangle;
    near.corners = corners_of(tree.part(), triangle);
  }
  count_ += static_cast<int>(found_.size());
  looks.spend(LookCosts::fetched * static_cast<long>(found_.size()));
  return true;
}

void NearTriangles::look_from(const ProxyWorld& world, const Vec3& place_O) noexcept {
  for (int i = 0; i < world.surface_count(); ++i) {
    PartView& view = views_[static_cast<std::size_t>(i)];
    if (view.within_reach) view.at_P = world.in_part(i, place_O);
  }
}

bool NearTriangles::offer(const ProxyWorld& world, int surface, const Vec3& z,
                          std::span<const ProxyWall> walls, std::size_t& next, WorstWall& worst,
                          Looks& looks) noexcept {
  const PartView& view = views_[static_cast<std::size_t>(surface)];
  if (!view.within_reach) return true;
  const std::size_t from = view.first + next;
  const PartWay way(world, surface, view.at_P, z);
  const PartWalls before(world, surface, walls, way.from_P);
  const double way_m = way.way_P.norm() * longer, clear_m = 2 * world.tolerance_m();
  std::size_t worst_at = view.end;
  // In which order Embree finds a few decides what becomes of each.
  const long each = view.is_in_order ? 1 : LookCosts::of_few, told = view.is_in_order ? LookCosts::told : 0;
  std::size_t k = from;
  for (; k < view.end && !looks.are_spent(); ++k) {
    looks.spend(each);
    NearTriangle& near = near_[k];
    if (near.seen) {
      // An earlier look left a half space free. Where the way begins and ends well in front of it, the
      // triangle cannot block; a ball that touches is nearer than that, and looks again.
      const double here_m = near.least_gap_m(way.from_P), there_m = near.least_gap_m(way.to_P);
      if (std::min(here_m, there_m) >= clear_m) continue;
      // The gap shrinks by no more than the way is long. Even so this breach would not be the worst.
      if (here_m - way_m > worst.slack_m) continue;
    }
    if (before.hide(near.corners)) continue;
    if (near.look_from(way.from_P, world.clearance_m())) looks.spend(told);
    const long before_it = worst.looks;
    if (worst.offer_triangle(world, way, near.corners, near.triangle, near.first)) worst_at = k;
    if (view.is_in_order) looks.spend(worst.looks - before_it);
  }
  next = k - view.first;
  // It is likely the worst of the next way too, which then tells at once that others are not.
  if (worst_at != view.end) std::swap(near_[from], near_[worst_at]);
  return k == view.end;
}

double NearTriangles::room_m(const ProxyWorld& world, std::span<const ProxyWall> walls, const Vec3& centre_O,
                             double most_m) noexcept {
  double room_m = most_m;
  for (int i = 0; i < world.surface_count() && room_m > 0; ++i) {
    const PartView& view = views_[static_cast<std::size_t>(i)];
    if (!view.within_reach) continue;
    const Vec3 at_P = world.in_part(i, centre_O);
    const PartWalls before(world, i, walls, view.at_P);
    for (std::size_t k = view.first; k < view.end; ++k) {
      NearTriangle& near = near_[k];
      if (near.seen && near.least_gap_m(at_P) >= room_m) continue;
      if (before.hide(near.corners)) continue;
      near.look_from(at_P, world.clearance_m());
      room_m = std::min(room_m, near.gap_m);
    }
  }
  return room_m;
}

}  // namespace fingerpad
