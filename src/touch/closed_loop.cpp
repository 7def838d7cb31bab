#include "touch/closed_loop.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/number_text.hpp"
#include "motion/stable_stiffness.hpp"
#include "part/part.hpp"
#include "scene/scene.hpp"

namespace fingerpad {

Scene at_rate(Scene scene, const FingerPath& path) {
  scene.motion.rate_hz = path.rate_hz();
  scene.motion.rate_given = true;
  scene.motion.automatic_rate = false;
  return scene;
}

ClosedLoop::ClosedLoop(std::shared_ptr<const World> world, const Scene& scene, FingerPath path,
                       const std::vector<SceneChange>& changes, const ContactWrap& wrap)
    : world_(world),
      touch_(std::move(world), at_rate(scene, path), wrap),
      path_(std::move(path)),
      turns_(path_.turns()),
      was_in_hand_(path_.was_in_hand()),
      is_measured_(path_.has_measured_force()) {
  touch_.take_your_time();
  if (!changes.empty()) {
    swap_ = std::make_unique<TouchSwap>(world_, at_rate(scene, path_));
    swap_->schedule(changes);
  }
  if (!scene.hand) return;
  hand_settings_ = *scene.hand;
  double scene_m = 1 + path_.farthest_m();
  for (const Surface& surface : world_->surfaces) scene_m += surface.part ? surface.part->size_m() : 0;
  leash_m_ = 1e3 * scene_m;
  hand_.emplace(*scene.hand, 1 / path_.rate_hz());
  hand_->start(path_.at(0).p_WQ);
}

TickRecord ClosedLoop::next() noexcept {
  const FingerSample intended = path_.at(tick_);
  if (swap_) swap_->before_tick(touch_, intended.t_s);
  TickRecord record = hand_ ? next_in_hand(intended) : touch_.tick(intended);
  if (was_in_hand_ && !hand_) {
    record.encoded_W = intended.p_WQ;
    record.push_W_n = intended.push_W_n;
  }
  if (turns_) record.direction_W = intended.direction_W;
  if (is_measured_ && !hand_) record.residual_W_n = record.force_W_n - path_.measured_force_W_n(tick_);
  if (intended.attitude) record.attitude << intended.attitude->w(), intended.attitude->vec();
  ++tick_;
  return record;
}

TickRecord ClosedLoop::next_in_hand(const FingerSample& intended) noexcept {
  FingerSample felt = intended;
  felt.p_WQ = hand_->encoded_W();
  felt.push_W_n = hand_->push_W_n(intended.p_WQ);
  felt.velocity_W.reset();
  felt.normal_force_n.reset();
  TickRecord record = touch_.tick(felt);
  record.p_WQ = hand_->position_W();
  record.encoded_W = felt.p_WQ;
  record.push_W_n = felt.push_W_n;
  const Vec3 next = path_.at(std::min(tick_ + 1, path_.tick_count() - 1)).p_WQ;
  hand_->advance(intended.p_WQ, next, record.force_W_n);
  if (record.surface >= 0) last_surface_ = record.surface;
  const Vec3 stray_m = hand_->position_W() - next;
  diverged_ |= !stray_m.allFinite() || stray_m.cwiseAbs().maxCoeff() > leash_m_;
  return record;
}

std::string ClosedLoop::divergence() const {
  const std::string start =
      fmt::format("the hand's loop diverged at t = {} s, where it threw the finger over {} m off its motion",
                  rounded_text(path_.at(tick_ - 1).t_s, 4), rounded_text(leash_m_, 3));
  if (last_surface_ < 0)
    return start + ", though it touched nothing: raise rate_hz or mass_kg, or lower [hand] stiffness_n_per_m";
  const SurfaceProperties& surface = world_->surfaces[static_cast<std::size_t>(last_surface_)].properties;
  HeldWall wall = wall_under(hand_settings_, path_.rate_hz());
  wall.wall_damping_n_s_per_m = surface.damping_n_s_per_m;
  const double limit = stable_stiffness(wall);
  const std::string hand =
      fmt::format("that a hand of {} kg and {} N s/m holds stable on one wall{} at {} Hz{}",
                  rounded_text(wall.mass_kg, 4), rounded_text(wall.damping_n_s_per_m, 4),
                  wall.wall_damping_n_s_per_m > 0
                      ? fmt::format(" of {} N s/m", rounded_text(wall.wall_damping_n_s_per_m, 4))
                      : "",
                  rounded_text(path_.rate_hz(), 6),
                  wall.delay_ticks > 0 ? fmt::format(" with a delay of {} ticks", wall.delay_ticks) : "");
  const bool is_above = surface.stiffness_n_per_m > limit;
  return fmt::format(
      "{}: stiffness_n_per_m {} is {} {} N/m, the largest {}; {}soften the surface, raise "
      "rate_hz or give [hand] more damping_n_s_per_m",
      start, rounded_text(surface.stiffness_n_per_m, 6), is_above ? "above" : "below", rounded_text(limit, 4),
      hand,
      is_above ? ""
               : "yet several walls at once, or a stiff spring of the sticking friction, count "
                 "together: ");
}

}  // namespace fingerpad
