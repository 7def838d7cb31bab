#include "contact/proxy.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "contact/proxy_report.hpp"

namespace fingerpad {

Proxy::Proxy(std::vector<PlacedSurface> surfaces, double radius_m, Normals normals)
    : Proxy(std::make_unique<ProxySight>(ProxyWorld(std::move(surfaces), radius_m, normals))) {}

Proxy::Proxy(std::unique_ptr<ProxySight> sight) : sight_(std::move(sight)) {
  reset();
}

void Proxy::reset() noexcept {
  resume({});
}

void Proxy::resume(const ProxyState& state) noexcept {
  state_ = state;
  start_ = {};
  sight_->forget();
}

const ProxyContact& Proxy::move(const Vec3& p_WQ, double dt_s) noexcept {
  sight_->looks().renew();
  const Vec3 goal_O = p_WQ - world().p_WO();
  const double extent_m = world().extent_m();
  if (extent_m > 0 && !(goal_O.cwiseAbs().maxCoeff() <= ProxyLimits::farthest * extent_m)) {
    reset();
    return state_.contact;
  }
  begin_tick(dt_s);
  const bool was_behind = state_.contact.behind,
             was_free = !state_.contact.touching() && state_.contact.settled;
  const bool goes_on = std::exchange(state_.contact.broken_off, false) && state_.placed;
  if (!state_.placed && !start(goal_O)) return state_.contact;
  const Vec3 push = state_.place_O - state_.goal_O;
  state_.finger_m = (goal_O - state_.goal_O).norm();
  state_.goal_O = goal_O;
  if (goes_on || !sight_->carry(state_)) follow(leash_after(push, world(), state_), goes_on);
  state_.contact.behind = state_.contact.broken_off || (was_behind && !state_.contact.settled);
  const double left_s = was_free ? ProxyLimits::arrival_s : state_.arrives_s - dt_s;
  state_.arrives_s = state_.contact.broken_off ? std::max(0.0, left_s) : 0;
  return state_.contact;
}

void Proxy::begin_tick(double dt_s) noexcept {
  const ProxyContact& last = state_.contact;
  state_.last_push_W = last.touching() ? Vec3(last.depth_m * last.normal_W) : Vec3::Zero();
  state_.last_direction_W = last.direction_W;
  state_.rest_share = std::min(1.0, dt_s / ProxyLimits::release_s);
  state_.hopped = false;
  state_.contact.started = false;
}

/// Puts the proxy down; false where it has no place yet.
bool Proxy::start(const Vec3& goal_O) noexcept {
  const ProxyStart::End end = start_.go_on(world(), goal_O, sight_->looks());
  state_.contact = {};
  state_.contact.started = true;
  state_.contact.placed = state_.placed = end == ProxyStart::End::placed;
  state_.contact.behind = state_.contact.broken_off = end == ProxyStart::End::broken_off;
  if (!state_.placed) return false;
  state_.place_O = start_.place_O();
  state_.goal_O = goal_O;
  return true;
}

/// Takes the proxy after the finger: over a smooth edge or round what holds it, where that is known at once,
/// and by steps; then over smooth edges as long as that leads nearer.
/// @param goes_on  with the step that the last tick broke off; all else is for later, so that no two ticks
/// end at the same step
void Proxy::follow(ProxyLeash leash, bool goes_on) noexcept {
  Way way = Way::blocked;
  if (!goes_on) way = hop(leash);
  if (!goes_on && way == Way::blocked) way = roll(leash);
  if (way != Way::rests) settle(leash);
  // One hop that is felt is enough for a tick.
  for (int k = 0; k < ProxyLimits::most_hops && state_.contact.settled && !are_hops_felt(state_); ++k) {
    sight_->note_rest(state_);
    way = hop(leash);
    if (way == Way::blocked) break;
    if (way != Way::rests) settle(leash);
  }
  if (!sight_->slide(state_)) report(world(), state_);
}

/// Steps until the proxy is as close to the finger as it gets, or as its leash lets it.
void Proxy::settle(const ProxyLeash& leash) noexcept {
  const Vec3& goal_O = state_.goal_O;
  sight_->let_go();
  // How far a step may go on along bent walls: the first, which mostly ends it, not at all.
  double bent_m = 0;
  for (int k = 0; k < ProxyLimits::most_steps; ++k) {
    if (goal_O == state_.place_O) {
      sight_->drop_step();
      state_.hold = {};
      break;
    }
    if (sight_->looks().are_spent()) return break_off({});
    const ProxyStep step = sight_->step(state_, {leash.step_m, bent_m});
    if (step.end == StepEnd::broken_off) return break_off(step);
    if (advance(step, leash)) return;
    // Ways that converge get shorter by more than that.
    if (k == 0) {
      bent_m = leash.step_m;
    } else if (step.end == StepEnd::bent) {
      bent_m = ProxyLimits::next_bend * step.z.norm();
    }
  }
  state_.contact.settled = goal_O == state_.place_O;
}

/// Stays, with the walls that the step has found so far, or else those of before.
void Proxy::break_off(const ProxyStep& step) noexcept {
  state_.contact.settled = false;
  state_.contact.broken_off = true;
  if (step.wall_count > 0) state_.hold = step;
}

/// Goes the step as far as the leash lets it; true where the proxy has come to its end for this tick.
bool Proxy::advance(const ProxyStep& step, const ProxyLeash& leash) noexcept {
  const double share = leash.share_of(state_.place_O, step.z);
  state_.hold = step;
  state_.place_O += share * step.z;
  state_.contact.settled = !(share < 1);
  if (!state_.contact.settled) return true;
  if (step.end == StepEnd::truncated) return false;
  // One that found no way may have let go of all its walls, and is free of none.
  const bool is_free = step.wall_count == 0 && step.end != StepEnd::stuck;
  if (is_free) state_.place_O = step.goal_O;
  // Else the finger has gone on since the step was broken off.
  const bool is_last = step.goal_O == state_.goal_O;
  return is_last && (is_free || step.z.norm() <= world().tolerance_m() || is_at_rest(step));
}

/// Whether each triangle that holds the proxy shows it, from its new place, the wall that the step was made
/// with: another step would lead nowhere.
bool Proxy::is_at_rest(const ProxyStep& step) const noexcept {
  return std::all_of(step.held_by().begin(), step.held_by().end(), [this](const ProxyWall& wall) {
    if (wall.triangle < 0) return true;
    const ProxyWall here = world().wall_at(wall.surface, wall.triangle, state_.place_O);
    return here.least_m >= -world().touching_m() &&
           (here.normal - wall.normal).squaredNorm() <= ProxyLimits::same_wall * ProxyLimits::same_wall;
  });
}

/// Goes over the smooth convex edge to the neighbour that is nearer to the finger. Blocked while an earlier
/// hop is still on its way to be shown. What it gains is the facets', not the finger's, and does not count
/// towards the leash; what the proxy slides after it does.
Proxy::Way Proxy::hop(ProxyLeash& leash) noexcept {
  if (state_.lags) return Way::blocked;
  const auto walls = sight_->nearer_neighbour(state_);
  if (!walls) return Way::blocked;
  const Vec3 before_O = state_.place_O;
  const Way way = go_over(*walls, {});
  leash.centre_O += state_.place_O - before_O;
  state_.hopped |= way != Way::blocked;
  return way;
}

/// Goes on around the one triangle that holds the proxy, to where the finger is now. Blocked where another
/// way of holding it has to be looked for.
Proxy::Way Proxy::roll(const ProxyLeash& leash) noexcept {
  const ProxyWall* wall = state_.one_triangles_wall();
  if (wall == nullptr) return Way::blocked;
  const Vec3& place_O = state_.place_O;
  const ProxyWall here = world().wall_at(wall->surface, wall->triangle, place_O);
  if (std::abs(here.least_m) > world().touching_m()) return Way::blocked;
  const ProxyWall there = world().tangent_wall(wall->surface, wall->triangle, state_.goal_O, place_O);
  if (!(here.normal.dot(there.normal) > ProxyLimits::least_roll_cosine)) return Way::blocked;
  return go_over({here, there}, leash);
}

/// Goes from one wall to another, by way of where the ball lies on both. Blocked where something is in the
/// way, nothing is gained, or the leash is too short.
Proxy::Way Proxy::go_over(const WallPair& walls, const ProxyLeash& leash) noexcept {
  sight_->looks().spend(LookCosts::hop);
  const Vec3 place_O = state_.place_O, goal = state_.goal_O - place_O;
  const double depth_m = walls.there.lack_m(goal), must_beat_m = goal.norm() - world().tolerance_m();
  const Vec3 far = goal + depth_m * walls.there.normal;
  const std::optional<Vec3> edge = on_both_walls(0.5 * far, walls.here, walls.there);
  if (!edge) return Way::blocked;
  // Over an edge that is near, not where the planes meet at all.
  if (edge->norm() > ProxyLimits::longest_way_over * far.norm() || leash.share_of(place_O, far) < 1)
    return Way::blocked;
  const std::optional<ProxyStep> step =
      sight_->step_over({place_O, state_.goal_O, walls, *edge, far, depth_m, must_beat_m});
  if (!step) return Way::blocked;
  if (step->end == StepEnd::broken_off) {
    state_.contact.broken_off = true;
    return Way::blocked;
  }
  const Vec3 new_place_O = step->from_O + step->z;
  if (step->end != StepEnd::at_rest) {
    if (!((state_.goal_O - new_place_O).norm() < must_beat_m)) return Way::blocked;
    if (leash.share_of(place_O, new_place_O - place_O) < 1) return Way::blocked;
    sight_->let_go();
  }
  state_.contact.settled = true;
  state_.place_O = new_place_O;
  state_.hold = *step;
  const bool rests = step->end == StepEnd::at_rest || (step->end != StepEnd::truncated && is_at_rest(*step));
  return rests ? Way::rests : Way::gone;
}

}  // namespace fingerpad
