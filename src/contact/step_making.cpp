#include "contact/step_making.hpp"

#include <algorithm>

#include "contact/bent_walls.hpp"
#include "contact/proxy_limits.hpp"
#include "contact/proxy_sight.hpp"

namespace fingerpad {

void StepMaking::begin(const ProxySight& sight, const Vec3& goal_O, double most_m, double bent_m) noexcept {
  goal_ = goal_O - sight.place_O();
  most_m_ = most_m;
  bent_m_ = bent_m;
  // What the projection leaves behind a wall by rounding must not count as a breach.
  const double rounding_m = ProxyLimits::rounding * goal_.cwiseAbs().maxCoeff() +
                            sight.world().plane_rounding_m(sight.place_O(), goal_O);
  slack_m_ = sight.world().slack_m() + rounding_m;
  breach_m_ = sight.world().tolerance_m() + ProxyLimits::breach_roundings * rounding_m;
  step_ = {};
  step_.from_O = sight.place_O();
  step_.goal_O = goal_O;
  pass_ = 0;
  round_ = LookRound(breach_m_);
  is_amid_round_ = is_guessed_ = false;
  held_.reset();
}

ProxyStep StepMaking::go_on(ProxySight& sight) noexcept {
  for (; pass_ < ProxyLimits::most_passes; ++pass_) {
    if (!is_amid_round_) {
      if (!project(sight)) return stuck();
      round_ = LookRound(breach_m_);
    }
    is_amid_round_ = !sight.offer_all(step_.z, step_.held_by(), round_);
    if (is_amid_round_) return waiting();
    if (round_.worst.wall || let_go_of_far_walls(sight)) continue;
    if (held_ && leads_nowhere(sight)) step_ = *held_;
    go_on_along_bend(sight);
    return step_;
  }
  return stuck();
}

/// The projection onto the walls found so far and the last round's, as far as it may go. False where they
/// leave nothing.
bool StepMaking::project(ProxySight& sight) noexcept {
  sight.looks().spend(LookCosts::projection);
  const std::optional<Vec3> z = step_.project(goal_, round_.worst.wall, slack_m_);
  if (!z) return false;
  const double length_m = z->norm();
  const bool is_too_long = length_m > most_m_;
  step_.end = is_too_long ? StepEnd::truncated : StepEnd::whole;
  step_.z = is_too_long ? Vec3(*z * (most_m_ / length_m)) : *z;
  return true;
}

bool StepMaking::leads_nowhere(const ProxySight& sight) const noexcept {
  return step_.z.norm() <= sight.world().tolerance_m();
}

/// A wall stands for how the straight way to the goal meets its triangle. Where another wall turns the way
/// off, the ball may never come there: both together would hold it in thin air, for ever. So where a step
/// leads nowhere, walls whose triangles the ball is far from are looked for anew, once, beside those that
/// it is not; where that leads nowhere either, all hold as before. Where it is far from all, and some were
/// guessed, the step begins anew without them. False where there is nothing to let go.
bool StepMaking::let_go_of_far_walls(ProxySight& sight) noexcept {
  const int count = step_.wall_count;
  if (held_ || count < (is_guessed_ ? 1 : 2) || !leads_nowhere(sight)) return false;
  sight.looks().spend(LookCosts::told * count);
  ProxyStep touched = step_;
  const auto is_far = [&](const ProxyWall& wall) { return sight.world().is_far_from(wall, step_.from_O); };
  touched.wall_count = static_cast<int>(
      std::remove_copy_if(step_.held_by().begin(), step_.held_by().end(), touched.walls.begin(), is_far) -
      touched.walls.begin());
  if (touched.wall_count == count || (touched.wall_count == 0 && !is_guessed_)) return false;
  if (touched.wall_count > 0) held_ = step_;
  step_ = touched;
  is_guessed_ = false;
  return true;
}

/// Where walls bend away the step goes on along them, if that is free, no farther than was asked for.
void StepMaking::go_on_along_bend(ProxySight& sight) noexcept {
  if (!(bent_m_ > 0) || step_.end != StepEnd::whole || step_.wall_count == 0) return;
  sight.looks().spend(LookCosts::told * step_.wall_count);
  const Vec3 on = way_along_bend(sight.world(), step_);
  const double on_m = on.norm(), room_m = std::min(bent_m_, most_m_) - step_.z.norm();
  if (!(on_m > 0 && room_m > 0)) return;
  const Vec3 z = step_.z + std::min(1.0, room_m / on_m) * on;
  if (!((z - goal_).squaredNorm() < goal_.squaredNorm())) return;  // no nearer than where it began
  LookRound round(breach_m_);
  if (!sight.offer_all(z, step_.held_by(), round) || round.worst.wall) return;
  step_.z = z;
  if (on_m <= room_m) step_.end = StepEnd::bent;
}

/// Rounding has left the walls nothing in common, or brings up ever others: it goes nowhere.
ProxyStep StepMaking::stuck() noexcept {
  step_.end = StepEnd::stuck;
  step_.z.setZero();
  return step_;
}

/// Of a step whose looks are spent: it goes nowhere, with the walls found so far.
ProxyStep StepMaking::waiting() const noexcept {
  ProxyStep so_far = step_;
  so_far.z.setZero();
  so_far.end = StepEnd::broken_off;
  if (so_far.wall_count == 0 && round_.worst.wall) {
    // Whatever else blocks, this does.
    so_far.wall_count = 1;
    so_far.walls[0] = *round_.worst.wall;
    so_far.share_m[0] = so_far.walls[0].lack_m(goal_);
  }
  return so_far;
}

}  // namespace fingerpad
