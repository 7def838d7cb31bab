#include <algorithm>
#include <limits>

#include "contact/proxy_limits.hpp"
#include "contact/proxy_views.hpp"

// How a view is made: as wide as is wanted, and no richer than what is kept at hand.

namespace fingerpad {

using Limits = ProxyMemoryLimits;

/// Without parts there is nothing to be looked for, however far.
double ProxyViews::widest_view_m() const noexcept {
  return world_.extent_m() > 0 ? world_.extent_m() : std::numeric_limits<double>::infinity();
}

/// Makes the next views wider or narrower, after what a search has found. One that was broken off has seen to
/// that itself.
void ProxyViews::suit_view() noexcept {
  if (is_blind()) return;
  const int count = near_.count();
  if (is_cut_) view_reach_m_ = std::min(view_reach_m_, search_reach_m_);
  if (count > Limits::rich_view)
    view_reach_m_ = std::min(view_reach_m_, std::max(Limits::shrinkage * search_reach_m_, least_view_m()));
  // On a smooth surface there are about so many times as many within so many times the reach.
  if (!is_cut_ && search_reach_m_ >= view_reach_m_ && view_reach_m_ < least_view_m()) {
    const double room = Limits::filled_view * usual_view_ / std::max(count, 1);
    view_reach_m_ = std::min(std::max(room, 1.0) * view_reach_m_, least_view_m());
  }
  if (count < Limits::poor_view && search_reach_m_ >= view_reach_m_)
    view_reach_m_ = std::min(Limits::growth * view_reach_m_, widest_view_m());
}

/// Fills the view. False where it is too rich.
bool ProxyViews::search(const Vec3& place_O, double reach_m, int most) noexcept {
  is_past_views_ = false;
  place_O_ = place_O;
  reach_m_ = search_reach_m_ = reach_m;
  return near_.search(world_, place_O, reach_m, most, blockers_[0], looks_);
}

/// However rich, a view reaches so far.
double ProxyViews::least_view_m() const noexcept {
  return std::max(Limits::least_ticks * finger_m_, Limits::least_share * world_.clearance_m());
}

/// The looks are spent; the next tick goes on with this reach.
void ProxyViews::see_nothing(double next_reach_m) noexcept {
  view_reach_m_ = std::min(view_reach_m_, next_reach_m);
  reach_m_ = search_reach_m_ = -1;
}

/// Looks at less where there is too much within reach. Where a ball fits its surroundings so well that no
/// reach is short enough, at more triangles than usual; where these are too many, the trees will be asked
/// instead.
void ProxyViews::search_around(const Vec3& place_O, double reach_m) noexcept {
  is_past_views_ = false;
  place_O_ = place_O;
  if (overflow_ && place_O == search_place_O_) return;
  search_place_O_ = place_O;
  is_cut_ = overflow_ = false;
  double shorter_m = reach_m;
  for (int cut = 0; cut <= Limits::most_cuts && !is_rich_; ++cut, shorter_m *= Limits::cut) {
    if (looks_.are_spent()) return see_nothing(shorter_m);
    const bool begins_late = looks_.are_half_spent();
    if (search(place_O, shorter_m, usual_view_)) return;
    if (looks_.are_spent() && begins_late) return see_nothing(shorter_m);
    is_cut_ = true;
    if (shorter_m < Limits::hopeless_share * world_.clearance_m()) break;
  }
  is_rich_ = true;
  const long before = looks_.spent();
  const bool begins_late = before > Limits::late;
  if (begins_late && (looks_.are_half_spent() || looks_.left() < rich_looks_))
    return see_nothing(view_reach_m_);
  is_cut_ = false;
  view_reach_m_ = std::max(view_reach_m_, least_view_m());
  overflow_ = !search(place_O, std::max(reach_m, view_reach_m_), Limits::richest_view);
  if (overflow_ && looks_.are_spent() && begins_late) {
    overflow_ = false;
    return see_nothing(view_reach_m_);
  }
  if (overflow_ && world_.radius_m() > 0) crowded_place_O_ = place_O;
  rich_looks_ = looks_.spent() - before;
  is_rich_ = overflow_ || near_.count() > usual_view_;
}

}  // namespace fingerpad
