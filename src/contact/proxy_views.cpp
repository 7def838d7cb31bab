#include "contact/proxy_views.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/proxy_limits.hpp"

namespace fingerpad {
namespace {

using Limits = ProxyMemoryLimits;
constexpr double rounded_up = 1 + Limits::rounding, rounded_down = 1 - Limits::rounding;

/// How far the finger is off to the side of its last push: what the proxy has to slide, about.
double aside_m(const ProxyState& s) noexcept {
  const Vec3 way = s.goal_O - s.place_O;
  if (s.last_push_W.isZero(0)) return way.norm();
  return (way - way.dot(s.last_direction_W) * s.last_direction_W).norm();
}

int largest_fan(const Part& part) {
  std::vector<int> fan(static_cast<std::size_t>(part.welded_count), 0);
  for (int t = 0; t < part.triangle_count(); ++t) {
    for (int k = 0; k < 3; ++k) ++fan[static_cast<std::size_t>(part.welded(k, t))];
  }
  return fan.empty() ? 0 : *std::max_element(fan.begin(), fan.end());
}

}  // namespace

ProxyViews::ProxyViews(ProxyWorld world, Looks looks) : LimitedSight(std::move(world), looks), near_(world_) {
  for (const int i : world_.parts()) {
    usual_view_ =
        std::max(usual_view_, Limits::beside_fans + Limits::fans_in_view * largest_fan(world_.part(i)));
  }
  usual_view_ = std::min(usual_view_, Limits::most_usual_view);
  seeds_.resize(static_cast<std::size_t>(world_.surface_count()));
  ProxyViews::forget();
}

void ProxyViews::forget() noexcept {
  ProxySight::forget();
  near_.clear();
  std::fill(seeds_.begin(), seeds_.end(), -1);
  search_reach_m_ = -1;
  blockers_ = {};
  rich_looks_ = 0;
  is_cut_ = is_rich_ = overflow_ = is_past_views_ = false;
  short_step_m_ = 0;
  short_step_looks_ = 0;
  crowded_place_O_ = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
  ahead_goal_O_ = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
  ahead_ = {};
  view_reach_m_ = Limits::first_view * widest_view_m();
  ProxyViews::let_go();
}

void ProxyViews::let_go() noexcept {
  asked_m_ = view_reach_m_;
  falls_short_ = goes_past_views_ = false;
}

ProxyStep ProxyViews::step(const ProxyState& s, const StepTerms& terms) noexcept {
  if (making_.is_underway()) {
    const ProxyStep step = making_.go_on(*this);
    note_blockers(step);
    return step;
  }
  const Vec3 &place_O = s.place_O, &goal_O = s.goal_O;
  if (goes_past_views_ || is_outrun(place_O, std::min(aside_m(s), terms.most_m)))
    return step_past_views(place_O, goal_O, terms);
  const long before = looks_.spent();
  if (falls_short_ && near_.count() <= Limits::rich_view) asked_m_ *= Limits::wider_view;
  asked_m_ = look_around(place_O, asked_m_, falls_short_);
  if (is_blind()) return broken_off_step();
  if (place_O_ == search_place_O_) suit_view();
  if (is_crowded_about(place_O)) return step_past_views(place_O, goal_O, terms);
  if (overflow_) reach_m_ = (goal_O - place_O).norm() * rounded_up;
  making_.begin(*this, goal_O, std::min(reach_m_, terms.most_m * rounded_up), terms.bent_m);
  const ProxyStep step = making_.go_on(*this);
  note_blockers(step);
  falls_short_ = step.end == StepEnd::truncated && reach_m_ <= terms.most_m;
  note_short_step(step, looks_.spent() - before);
  return step;
}

ProxyStep ProxyViews::look_and_step_from_edge(const WayOver& way) noexcept {
  const double rest_m = (way.far - way.edge).norm();
  see_from(way.place_O + way.edge, std::min(rest_m, Limits::serves_again * view_reach_m_),
           std::max(view_reach_m_, rest_m), Vec3::Zero());
  if (is_blind() || overflow_) return broken_off_step();
  return step_from_edge(way);
}

bool ProxyViews::is_seen_free(const WayOver& way) noexcept {
  return !overflow_ && reach_m_ >= way.edge.norm() && is_free(way.edge, way.walls.here);
}

void ProxyViews::look_over_edge(const WayOver& way) noexcept {
  const double way_m = way.edge.norm(), far_m = way.far.norm(),
               need_m = Limits::past_edge * std::max(far_m, way_m);
  const double reach_m = view_reach_m_, both_m = way_m + (way.far - way.edge).norm();
  if (need_m < (1 - Limits::lead) * reach_m) {
    look_ahead(way.place_O, need_m, Limits::lead * reach_m / far_m * way.far);
  } else if (!look_again(way.place_O, both_m * rounded_up)) {
    // What the step from the edge will ask for, too.
    search_around(way.place_O, std::max(reach_m, both_m + Limits::serves_again * reach_m));
    suit_view();
  }
}

bool ProxyViews::look_again(const Vec3& place_O, double need_m) noexcept {
  const double left_m = search_reach_m_ - (place_O - search_place_O_).norm() * rounded_up;
  if (overflow_ || !(left_m >= need_m)) return false;
  is_past_views_ = false;
  place_O_ = place_O;
  reach_m_ = left_m;
  near_.look_from(world_, place_O);
  return true;
}

/// Looks at everything within `reach_m`, or, where that is too much, within less; returns how far. What the
/// last search found serves again as long as it shows half as far.
double ProxyViews::look_around(const Vec3& place_O, double reach_m, bool anew) noexcept {
  if (anew || !look_again(place_O, Limits::serves_again * reach_m)) search_around(place_O, reach_m);
  return std::max(reach_m_, 0.0);
}

void ProxyViews::look_ahead(const Vec3& place_O, double need_m, const Vec3& ahead) noexcept {
  if (see_from(place_O, need_m, view_reach_m_, ahead)) suit_view();
}

/// Sees to a view that shows as far as `need_m`; true where the trees were searched for it.
bool ProxyViews::see_from(const Vec3& place_O, double need_m, double reach_m, const Vec3& ahead) noexcept {
  if (look_again(place_O, need_m)) return false;
  search_around(place_O + ahead, reach_m);
  if (!look_again(place_O, need_m)) search_around(place_O, reach_m);  // cut short there
  return true;
}

bool ProxyViews::offer_part(int surface, const Vec3& z, std::span<const ProxyWall> walls,
                            LookRound& round) noexcept {
  if (overflow_ || is_past_views_) return LimitedSight::offer_part(surface, z, walls, round);
  return near_.offer(world_, surface, z, walls, round.next, round.worst, looks_);
}

double ProxyViews::room_in_front_of(std::span<const ProxyWall> walls, const Vec3& centre_O) noexcept {
  if (overflow_ || looks_.left() < near_.count()) return 0;
  looks_.spend(near_.count());
  const double most_m = search_reach_m_ - (centre_O - search_place_O_).norm() * rounded_up;
  return std::max(0.0, near_.room_m(world_, walls, centre_O, most_m, looks_));
}

double ProxyViews::room_m(const Vec3& place_O, double least_m, double enough_m) noexcept {
  double room_m = enough_m;
  for (const int i : world_.parts()) {
    const TriangleTree& tree = *world_.surface(i).tree;
    const Vec3 q_P = world_.in_part(i, place_O);
    const double to_box_m = (q_P.cwiseAbs() - tree.part().half_extent).cwiseMax(0.0).norm() * rounded_down;
    if (to_box_m - world_.clearance_m() >= room_m) continue;
    if (to_box_m > Limits::far_from_box * tree.part().size_m()) {
      room_m = std::min(room_m, to_box_m - world_.clearance_m());
      continue;
    }
    int& seed = seeds_[static_cast<std::size_t>(i)];
    if (seed >= 0) {
      const double left_m = world_.approach(i, seed, place_O).distance_m - world_.clearance_m();
      if (left_m < least_m) return std::min(room_m, left_m);
    }
    ClosestWalk walk{seed, 0};
    const auto closest = tree.closest(q_P, std::max(room_m, 0.0) + world_.clearance_m(), walk, looks_);
    if (!closest) return 0;
    if (closest->triangle < 0) continue;
    seed = closest->triangle;
    room_m = std::min(room_m, std::sqrt(closest->at.distance2_m2) - world_.clearance_m());
  }
  for (const int i : world_.planes()) room_m = std::min(room_m, -world_.plane_wall(i, place_O).least_m);
  return room_m;
}

/// Whether a place keeps the clearance from every plane but one.
bool ProxyViews::is_clear_of_planes(const Vec3& place_O, int but) const noexcept {
  const std::span<const int> planes = world_.planes();
  return std::none_of(planes.begin(), planes.end(),
                      [&](int i) { return i != but && world_.plane_wall(i, place_O).least_m > 0; });
}

}  // namespace fingerpad
