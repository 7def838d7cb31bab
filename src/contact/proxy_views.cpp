#include "contact/proxy_views.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace fingerpad {

using Limits = ProxyMemoryLimits;

namespace {

/// How far the finger is off to the side of its last push: what the proxy has to slide, about.
double aside_m(const ProxyState& s) noexcept {
  const Vec3 way = s.goal_O - s.place_O;
  if (s.last_push_W.isZero(0)) return way.norm();
  return (way - way.dot(s.last_direction_W) * s.last_direction_W).norm();
}

}  // namespace

ProxyViews::ProxyViews(ProxyWorld world, Looks looks)
    : LimitedSight(std::move(world), looks),
      view_(world_, looks_, at_),
      likely_(world_, looks_),
      seeds_(static_cast<std::size_t>(world_.surface_count())) {
  ProxyViews::forget();
}

void ProxyViews::forget() noexcept {
  ProxySight::forget();
  view_.forget();
  likely_.forget();
  std::fill(seeds_.begin(), seeds_.end(), -1);
  short_step_m_ = 0;
  short_step_looks_ = 0;
  ProxyViews::let_go();
}

void ProxyViews::let_go() noexcept {
  asked_m_ = view_.next_reach_m();
  falls_short_ = goes_past_views_ = false;
  likely_.let_go();
}

ProxyStep ProxyViews::step(const ProxyState& s, const StepTerms& terms) noexcept {
  if (making_.is_underway()) {
    const ProxyStep step = making_.go_on(*this);
    note_blockers(step);
    return step;
  }
  const Vec3 &place_O = s.place_O, &goal_O = s.goal_O;
  if (goes_past_views_ || is_outrun(place_O, std::min(aside_m(s), terms.most_m)))
    return step_past_views(s, terms);
  const long before = looks_.spent();
  if (falls_short_ && !view_.is_rich()) asked_m_ *= Limits::wider_view;
  asked_m_ = view_.look_around(place_O, asked_m_, falls_short_);
  if (view_.is_blind()) return broken_off_step();
  if (at_.place_O == view_.search_place_O()) view_.suit();
  if (view_.is_crowded_about(place_O)) return step_past_views(s, terms);
  if (view_.overflows()) at_.reach_m = (goal_O - place_O).norm() * (1 + Limits::rounding);
  making_.begin(*this, goal_O, std::min(at_.reach_m, terms.most_m * (1 + Limits::rounding)), terms.bent_m);
  const ProxyStep step = making_.go_on(*this);
  falls_short_ = step.end == StepEnd::truncated && at_.reach_m <= terms.most_m;
  // A view that was cut to less than `hopeless_share` does not count: the richest view comes next, which
  // shows more.
  const bool is_hopeless = view_.is_cut() && at_.reach_m < Limits::hopeless_share * world_.clearance_m();
  if (falls_short_ && view_.is_rich() && !is_hopeless) {
    short_step_m_ = step.z.norm();
    short_step_looks_ = looks_.spent() - before;
  }
  if (falls_short_ && !s.contact.touching() && bends_in_the_air(step)) return step_past_views(s, terms);
  note_blockers(step);
  return step;
}

/// Whether a step has been turned off its straight way before the ball is at what turns it. One that is cut
/// short so goes on from beside that way, and may come by another side of what stands there.
bool ProxyViews::bends_in_the_air(const ProxyStep& step) const noexcept {
  const std::span<const ProxyWall> walls = step.held_by();
  return !walls.empty() && std::none_of(walls.begin(), walls.end(), [this](const ProxyWall& wall) {
    return wall.least_m >= -world_.touching_m();
  });
}

/// A step that the trees are asked for along its whole way, as the plain sight does; but it begins with the
/// walls that likely hold it.
ProxyStep ProxyViews::step_past_views(const ProxyState& s, const StepTerms& terms) noexcept {
  const double way_m = std::min((s.goal_O - s.place_O).norm(), terms.most_m);
  likely_.find(s.place_O, s.goal_O, way_m, view_.blockers());
  at_ = {s.place_O, way_m * (1 + Limits::rounding)};
  view_.leave();
  goes_past_views_ = true;
  falls_short_ = false;
  // Walls bend for a step that ends at those where it began.
  making_.begin(*this, s.goal_O, at_.reach_m, likely_.has_one_ahead() ? 0 : terms.bent_m);
  for (const ProxyWall& wall : likely_.found()) making_.guess(wall);
  const ProxyStep step = making_.go_on(*this);
  note_blockers(step);
  return step;
}

/// Of a step that was broken off some walls may be missing: it stays where those of before hold it.
void ProxyViews::note_blockers(const ProxyStep& step) noexcept {
  if (step.wall_count > 0 && step.end != StepEnd::broken_off) view_.note_blockers(step.held_by());
}

bool ProxyViews::is_outrun(const Vec3& place_O, double way_m) const noexcept {
  return view_.is_crowded_about(place_O) || Limits::eager * way_m * static_cast<double>(short_step_looks_) >
                                                short_step_m_ * static_cast<double>(looks_.left());
}

ProxyStep ProxyViews::look_and_step_from_edge(const WayOver& way) noexcept {
  const double rest_m = (way.far - way.edge).norm(), reach_m = view_.next_reach_m();
  view_.see_from(way.place_O + way.edge, std::min(rest_m, Limits::serves_again * reach_m),
                 std::max(reach_m, rest_m), Vec3::Zero());
  if (view_.is_blind() || view_.overflows()) return broken_off_step();
  return step_from_edge(way);
}

bool ProxyViews::is_seen_free(const WayOver& way) noexcept {
  return !view_.overflows() && at_.reach_m >= way.edge.norm() && is_free(way.edge, way.walls.here);
}

bool ProxyViews::offer_part(int surface, const Vec3& z, std::span<const ProxyWall> walls,
                            LookRound& round) noexcept {
  if (view_.overflows() || view_.is_left()) return LimitedSight::offer_part(surface, z, walls, round);
  return view_.offer(surface, z, walls, round);
}

double ProxyViews::room_m(const Vec3& place_O, double least_m, double enough_m) noexcept {
  double room_m = enough_m;
  for (const int i : world_.parts()) {
    const TriangleTree& tree = *world_.surface(i).tree;
    const Vec3 q_P = world_.in_part(i, place_O);
    const double to_box_m =
        (q_P.cwiseAbs() - tree.part().half_extent).cwiseMax(0.0).norm() * (1 - Limits::rounding);
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
