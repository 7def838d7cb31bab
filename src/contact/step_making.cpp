#include "contact/step_making.hpp"

#include <algorithm>

#include "contact/bent_walls.hpp"
#include "contact/proxy_limits.hpp"
#include "contact/proxy_sight.hpp"

namespace fingerpad {

void StepMaking::begin(const ProxySight& sight, const Vec3& goal_O, double most_m, double bent_m) noexcept {
  is_underway_ = is_amid_round_ = false;
  goal_ = goal_O - sight.place_O();
  step_ = {};
  step_.goal_O = goal_O;
  most_m_ = most_m;
  bent_m_ = bent_m;
  has_let_go_ = is_guessed_ = false;
  pass_ = 0;
  count_ = 0;
  // What the projection leaves behind a wall by rounding must not count as a breach.
  const double rounding_m = ProxyLimits::rounding * goal_.cwiseAbs().maxCoeff() +
                            sight.world().plane_rounding_m(sight.place_O(), goal_O);
  slack_m_ = sight.world().slack_m() + rounding_m;
  breach_m_ = sight.world().tolerance_m() + ProxyLimits::breach_roundings * rounding_m;
}

/// The projection onto the walls found so far, as far as it may go. False where they leave nothing.
bool StepMaking::project(ProxySight& sight) noexcept {
  sight.looks().spend(LookCosts::projection);
  const ProxyProjection p = project_onto_walls(goal_, std::span(walls_.data(), count_), slack_m_);
  if (!p.found) return false;
  step_.wall_count = p.active_count;
  step_.share_m = p.share_m;
  count_ = static_cast<std::size_t>(p.active_count);
  // The active ones are named in rising order.
  for (std::size_t k = 0; k < count_; ++k)
    step_.walls[k] = walls_[k] = walls_[static_cast<std::size_t>(p.active[k])];
  const double length_m = p.z.norm();
  step_.truncated = length_m > most_m_;
  step_.z = step_.truncated ? Vec3(p.z * (most_m_ / length_m)) : p.z;
  return true;
}

/// Where that is free, and no farther than was asked for.
void StepMaking::go_on_along_bend(ProxySight& sight) noexcept {
  if (!(bent_m_ > 0) || step_.truncated || step_.wall_count == 0) return;
  sight.looks().spend(LookCosts::told * step_.wall_count);
  const Vec3 on = way_along_bend(sight.world(), sight.place_O(), step_);
  const double on_m = on.norm(), room_m = std::min(bent_m_, most_m_) - step_.z.norm();
  if (!(on_m > 0 && room_m > 0)) return;
  const Vec3 z = step_.z + std::min(1.0, room_m / on_m) * on;
  if (!((z - goal_).squaredNorm() < goal_.squaredNorm())) return;  // no nearer than where it began
  LookRound round;
  round.worst.slack_m = -breach_m_;
  if (!sight.offer_all(z, step_.held_by(), round) || round.worst.wall) return;
  step_.z = z;
  step_.bent = on_m <= room_m;
}

/// A wall stands for how the straight way to the goal meets its triangle. Where another wall turns the way
/// off, the ball may never come there: both together would hold it in thin air, for ever. So where a step
/// leads nowhere, walls whose triangles the ball is far from are looked for anew, once, beside those that
/// it is not; where that leads nowhere either, all hold as before. Where it is far from all, and some were
/// guessed, the step begins anew without them. False where there is nothing to let go.
bool StepMaking::let_go_of_far_walls(ProxySight& sight) noexcept {
  if (has_let_go_ || count_ < (is_guessed_ ? 1 : 2)) return false;
  if (step_.z.norm() > sight.world().tolerance_m()) return false;
  sight.looks().spend(LookCosts::told * static_cast<long>(count_));
  std::size_t touched = 0;
  for (std::size_t k = 0; k < count_; ++k) {
    if (!sight.world().is_far_from(walls_[k], sight.place_O())) walls_[touched++] = walls_[k];
  }
  if (touched == count_ || (touched == 0 && !is_guessed_)) return false;
  if (touched > 0) {
    held_ = step_;
    has_let_go_ = true;
  }
  is_guessed_ = false;
  count_ = touched;
  return is_underway_ = true;
}

ProxyStep StepMaking::go_on(ProxySight& sight) noexcept {
  is_underway_ = true;
  for (; pass_ < ProxyLimits::most_passes; ++pass_) {
    if (!is_amid_round_) {
      round_ = {};
      round_.worst.slack_m = -breach_m_;
      if (!project(sight)) {
        is_underway_ = false;
        step_.stuck = true;
        step_.z.setZero();
        return step_;
      }
    }
    is_amid_round_ = !sight.offer_all(step_.z, step_.held_by(), round_);
    if (is_amid_round_) break;
    is_underway_ = round_.worst.wall.has_value();
    if (!is_underway_) {
      if (let_go_of_far_walls(sight)) continue;
      if (has_let_go_ && step_.z.norm() <= sight.world().tolerance_m()) step_ = held_;
      go_on_along_bend(sight);
      return step_;
    }
    walls_[count_++] = *round_.worst.wall;
  }
  if (pass_ == ProxyLimits::most_passes) {
    if (!is_amid_round_) round_ = {};
    is_amid_round_ = !sight.sweep_all(step_.z, round_);
    is_underway_ = is_amid_round_;
    step_.stuck = true;
    if (!is_underway_) step_.z *= round_.free_share;
  }
  return is_underway_ ? waiting() : step_;
}

/// Of a step whose looks are spent: it goes nowhere, with the walls found so far.
ProxyStep StepMaking::waiting() const noexcept {
  ProxyStep so_far = step_;
  so_far.z.setZero();
  so_far.stuck = so_far.broken_off = true;
  if (so_far.wall_count == 0 && round_.worst.wall) {
    // Whatever else blocks, this does.
    so_far.wall_count = 1;
    so_far.walls[0] = *round_.worst.wall;
    so_far.share_m[0] = so_far.walls[0].lack_m(goal_);
  }
  return so_far;
}

}  // namespace fingerpad
