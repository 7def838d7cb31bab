#include "contact/proxy_view.hpp"

#include <algorithm>

namespace fingerpad {

using Limits = ProxyMemoryLimits;

namespace {

constexpr double rounded_up = 1 + Limits::rounding;

}  // namespace

ProxyView::ProxyView(const ProxyWorld& world, Looks& looks, Lookout& at)
    : world_(world), looks_(looks), at_(at), near_(world) {
  for (const int i : world.parts())
    usual_ = std::max(usual_, Limits::beside_fans + Limits::fans_in_view * world.part(i).largest_fan);
  usual_ = std::min(usual_, Limits::most_usual_view);
  forget();
}

void ProxyView::forget() noexcept {
  near_.clear();
  blockers_ = {};
  search_reach_m_ = -1;
  next_reach_m_ = Limits::first_view * widest_m();
  is_left_ = is_cut_ = is_crowded_ = overflows_ = false;
  rich_looks_ = 0;
  crowded_place_O_ = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
}

bool ProxyView::is_crowded_about(const Vec3& place_O) const noexcept {
  const double near_m = Limits::crowded_share * world_.clearance_m();
  return (place_O - crowded_place_O_).squaredNorm() <= near_m * near_m;
}

void ProxyView::note_blockers(std::span<const ProxyWall> walls) noexcept {
  blockers_ = {};
  std::transform(walls.begin(), walls.end(), blockers_.begin(), [](const ProxyWall& wall) {
    return Blocker{wall.surface, wall.triangle};
  });
}

double ProxyView::look_around(const Vec3& place_O, double reach_m, bool anew) noexcept {
  if (anew || !look_again(place_O, Limits::serves_again * reach_m)) search_around(place_O, reach_m);
  return std::max(at_.reach_m, 0.0);
}

bool ProxyView::see_from(const Vec3& place_O, double need_m, double reach_m, const Vec3& ahead) noexcept {
  if (look_again(place_O, need_m)) return false;
  search_around(place_O + ahead, reach_m);
  if (!look_again(place_O, need_m)) search_around(place_O, reach_m);  // cut short there
  return true;
}

void ProxyView::look_ahead(const Vec3& place_O, double need_m, const Vec3& ahead) noexcept {
  if (see_from(place_O, need_m, next_reach_m_, ahead)) suit();
}

void ProxyView::look_over_edge(const WayOver& way) noexcept {
  const double way_m = way.edge.norm(), far_m = way.far.norm(),
               need_m = Limits::past_edge * std::max(far_m, way_m);
  const double reach_m = next_reach_m_, both_m = way_m + (way.far - way.edge).norm();
  if (need_m < (1 - Limits::lead) * reach_m) {
    look_ahead(way.place_O, need_m, Limits::lead * reach_m / far_m * way.far);
  } else if (!look_again(way.place_O, both_m * rounded_up)) {
    // What the step from the edge will ask for, too.
    search_around(way.place_O, std::max(reach_m, both_m + Limits::serves_again * reach_m));
    suit();
  }
}

bool ProxyView::look_again(const Vec3& place_O, double need_m) noexcept {
  const double left_m = search_reach_m_ - (place_O - search_place_O_).norm() * rounded_up;
  if (overflows_ || !(left_m >= need_m)) return false;
  is_left_ = false;
  at_ = {place_O, left_m};
  near_.look_from(world_, place_O);
  return true;
}

double ProxyView::room_in_front_of(std::span<const ProxyWall> walls, const Vec3& centre_O) noexcept {
  if (overflows_ || looks_.left() < near_.count()) return 0;
  looks_.spend(near_.count());
  const double most_m = search_reach_m_ - (centre_O - search_place_O_).norm() * rounded_up;
  return std::max(0.0, near_.room_m(world_, walls, centre_O, most_m, looks_));
}

/// Without parts there is nothing to be looked for, however far.
double ProxyView::widest_m() const noexcept {
  return world_.extent_m() > 0 ? world_.extent_m() : std::numeric_limits<double>::infinity();
}

/// However rich, a view reaches so far.
double ProxyView::least_m() const noexcept {
  return std::max(Limits::least_ticks * finger_m_, Limits::least_share * world_.clearance_m());
}

void ProxyView::suit() noexcept {
  if (is_blind()) return;
  const int count = near_.count();
  if (is_cut_) next_reach_m_ = std::min(next_reach_m_, search_reach_m_);
  if (is_rich())
    next_reach_m_ = std::min(next_reach_m_, std::max(Limits::shrinkage * search_reach_m_, least_m()));
  // On a smooth surface there are about so many times as many within so many times the reach.
  if (!is_cut_ && search_reach_m_ >= next_reach_m_ && next_reach_m_ < least_m()) {
    const double room = Limits::filled_view * usual_ / std::max(count, 1);
    next_reach_m_ = std::min(std::max(room, 1.0) * next_reach_m_, least_m());
  }
  if (count < Limits::poor_view && search_reach_m_ >= next_reach_m_)
    next_reach_m_ = std::min(Limits::growth * next_reach_m_, widest_m());
}

/// Fills the view. False where it is too rich.
bool ProxyView::search(const Vec3& place_O, double reach_m, int most) noexcept {
  is_left_ = false;
  at_ = {place_O, reach_m};
  search_reach_m_ = reach_m;
  return near_.search(world_, place_O, reach_m, most, blockers_[0], looks_);
}

/// The looks are spent; the next tick goes on with this reach.
void ProxyView::see_nothing(double next_reach_m) noexcept {
  next_reach_m_ = std::min(next_reach_m_, next_reach_m);
  at_.reach_m = search_reach_m_ = -1;
}

/// Looks at less where there is too much within reach. Where a ball fits its surroundings so well that no
/// reach is short enough, at more triangles than usual; where these are too many, the trees will be asked
/// instead.
void ProxyView::search_around(const Vec3& place_O, double reach_m) noexcept {
  is_left_ = false;
  at_.place_O = place_O;
  if (overflows_ && place_O == search_place_O_) return;
  search_place_O_ = place_O;
  is_cut_ = overflows_ = false;
  double shorter_m = reach_m;
  for (int cut = 0; cut <= Limits::most_cuts && !is_crowded_; ++cut, shorter_m *= Limits::cut) {
    if (looks_.are_spent()) return see_nothing(shorter_m);
    const bool begins_late = looks_.are_half_spent();
    if (search(place_O, shorter_m, usual_)) return;
    if (looks_.are_spent() && begins_late) return see_nothing(shorter_m);
    is_cut_ = true;
    if (shorter_m < Limits::hopeless_share * world_.clearance_m()) break;
  }
  is_crowded_ = true;
  const long before = looks_.spent();
  const bool begins_late = before > Limits::late;
  if (begins_late && (looks_.are_half_spent() || looks_.left() < rich_looks_))
    return see_nothing(next_reach_m_);
  is_cut_ = false;
  next_reach_m_ = std::max(next_reach_m_, least_m());
  overflows_ = !search(place_O, std::max(reach_m, next_reach_m_), Limits::richest_view);
  if (overflows_ && looks_.are_spent() && begins_late) {
    overflows_ = false;
    return see_nothing(next_reach_m_);
  }
  if (overflows_ && world_.radius_m() > 0) crowded_place_O_ = place_O;
  rich_looks_ = looks_.spent() - before;
  is_crowded_ = overflows_ || near_.count() > usual_;
}

}  // namespace fingerpad
