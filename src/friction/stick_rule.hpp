#pragma once

#include <cmath>

#include "friction/bounded.hpp"
#include "friction/law_settings.hpp"
#include "friction/stick_walk.hpp"

namespace fingerpad {

/// When the pad gives way and when it sticks again.
struct StickRule {
  double v_min_m_per_s = 0.1;
  Restick restick = Restick::level;
  Events events = Events::exact;
  StickRemedy remedy{};
};

namespace stick_rule_parts {

/// Rounding of a spring that was set exactly on the limit (mu_d = mu_s) must not break the stick.
inline constexpr double rounding = 1 + 1e-12;

/// Slip along `direction`; the spring goes along, stretched to the slip force.
template <typename Spring>
inline Friction slip(const BoundedMotion& m, const Spring& spring, const PlaneVector& direction,
                     FrictionState& state) noexcept {
  Friction answer;
  answer.phase = Phase::slip;
  answer.force_n = (-m.mu_dynamic() * spring.load_n) * direction;
  state.stretch_m = spring.stretch_of(spring.ratio_at(m.mu_dynamic(), m.mu_static()) * direction);
  state.slip_direction = direction;
  state.slip_force_scale = 1;
  return answer;
}

/// What a spring at `ratio` answers, stuck or dragged along in slow slip.
template <typename Spring>
inline Friction spring_force(const BoundedMotion& m, const Spring& spring, const PlaneVector& ratio,
                             const PlaneVector& stretch_m, Phase phase, FrictionState& state) noexcept {
  Friction answer;
  answer.phase = phase;
  answer.stretch_m = stretch_m;
  answer.force_n = -(spring.load_n * spring.hardening(ratio, m.mu_static())) * ratio;
  state.stretch_m = stretch_m;
  return answer;
}

/// First touch, at any speed: unstretched, so that landing gives neither a jump nor energy.
template <typename Spring>
inline Friction touch_down(const BoundedMotion& m, const Spring& spring, FrictionState& state) noexcept {
  Friction answer = spring_force(m, spring, PlaneVector(), PlaneVector(), Phase::stick, state);
  answer.centre_moved = true;
  state.event_share = 0;
  return answer;
}

/// Teeth alone: in stick at the start, slow to the end, and holding again at once (`restick = "level"`).
template <typename Spring>
[[gnu::noinline]] Friction toothed(const BoundedMotion& m, const Spring& spring,
                                   FrictionState& state) noexcept {
  const BoundedState last(state);
  const double mu_static = m.mu_static();
  const StickEnd end = walk_of_teeth(spring.ratio_of(last.stretch_m()), spring.ratio_of(m.step_m()),
                                     spring.ratio_at(m.mu_dynamic(), mu_static), mu_static);
  Friction answer = spring_force(m, spring, end.ratio, spring.stretch_of(end.ratio), Phase::stick, state);
  answer.centre_moved = end.centre_moved;
  answer.ruptures = end.ruptures;
  state.event_share = end.last_event;
  return answer;
}

/// A tick that may hold an event, read as a straight way through it (`events = "exact"`).
template <typename Spring>
[[gnu::noinline]] Friction walked(const BoundedMotion& m, const Spring& spring, const StickRule& rule,
                                  FrictionState& state) noexcept {
  const BoundedState last(state);
  const Polar v = polar(m.velocity_m_per_s());
  StickWay way;
  way.ratio = spring.ratio_of(last.stretch_m());
  way.before = spring.ratio_of(last.last_step_m());
  way.now = spring.ratio_of(m.step_m());
  way.velocity = {last.last_velocity_m_per_s(), m.velocity_m_per_s()};
  way.direction_before =
      state.phase == Phase::slip ? last.slip_direction() : direction_of(way.velocity.before_m_per_s);
  const bool is_fast = v.length > rule.v_min_m_per_s;
  // Slow and the other way about: the finger has stopped in between, and slip has ended before it did.
  const bool has_turned = !is_fast && !(v.direction.dot(way.direction_before) > 0);
  way.direction_now = has_turned && way.direction_before.square() > 0 ? way.direction_before : v.direction;
  way.slipped_scale = last.slip_force_scale();
  const CoulombSlide slide{m.mu_static(), m.mu_dynamic(), rule.v_min_m_per_s, rule.restick == Restick::level};
  const StickEnd end = StickWalk(spring, slide, way).run(state.phase, last.event_share());

  const bool slides = end.phase == Phase::slip && (is_fast || !(end.ratio.square() > 0));
  Friction answer = slides
                        ? slip(m, spring, way.direction_now, state)
                        : spring_force(m, spring, end.ratio, spring.stretch_of(end.ratio), end.phase, state);
  if (!slides) {
    state.slip_direction = direction_of(end.ratio);
    state.slip_force_scale = 1;
  }
  answer.centre_moved = end.phase == Phase::stick && end.centre_moved;
  answer.ruptures = end.ruptures;
  state.event_share = end.last_event;
  return answer;
}

/// The same tested at ticks only, for comparison (`events = "tick"`): rupture before the force is written,
/// restick at the force of the last slip tick as it was written.
template <typename Spring>
[[gnu::noinline]] Friction ticked(const BoundedMotion& m, const Spring& spring, const StickRule& rule,
                                  FrictionState& state) noexcept {
  const BoundedState last(state);
  const Polar v = polar(m.velocity_m_per_s());
  const bool is_fast = v.length > rule.v_min_m_per_s;
  const PlaneVector moved = spring.ratio_of(last.stretch_m() + m.step_m());
  state.event_share = 0;
  if (state.phase == Phase::stick) {
    const PlaneVector pulled = direction_of(moved);
    Friction answer = slip(m, spring, is_fast ? v.direction : pulled, state);
    answer.ruptures = 1;
    return answer;
  }
  const double written = m.mu_dynamic() * last.slip_force_scale();
  const bool falls = !is_fast && (rule.restick == Restick::level ||
                                  is_longer(last.last_velocity_m_per_s(), rule.v_min_m_per_s));
  if (falls && written <= m.mu_static() * rounding) {
    const PlaneVector ratio = spring.ratio_at(written, m.mu_static()) * last.slip_direction();
    Friction answer = spring_force(m, spring, ratio, spring.stretch_of(ratio), Phase::stick, state);
    answer.centre_moved = true;
    return answer;
  }
  if (is_fast) return slip(m, spring, v.direction, state);
  const double rim = spring.ratio_at(m.mu_dynamic(), m.mu_static());
  const PlaneVector dragged = shortened(moved, rim);
  state.slip_direction = direction_of(dragged);
  state.slip_force_scale = 1;
  return spring_force(m, spring, dragged, spring.stretch_of(dragged), Phase::slip, state);
}

/// The rule without remedies. Ticks on which nothing happens end here; the others are walked through.
template <typename Spring>
[[gnu::always_inline]] inline Friction plain_rule(const TangentialMotion& motion, const Spring& spring,
                                                  const StickRule& rule, FrictionState& state) noexcept {
  const BoundedMotion m(motion);
  const BoundedState last(state);
  const TickVelocity velocity{last.last_velocity_m_per_s(), m.velocity_m_per_s()};
  Friction answer;
  bool is_done = false, is_toothed = false;
  if (state.phase == Phase::stick) {
    const PlaneVector stretch_m = last.stretch_m() + m.step_m();
    const PlaneVector ratio = spring.ratio_of(stretch_m);
    is_done = !is_longer(ratio, m.mu_static() * rounding) && !(state.event_share > 0.5);
    if (is_done) answer = spring_force(m, spring, ratio, stretch_m, Phase::stick, state);
    is_toothed = !is_done && rule.restick == Restick::level && rule.events == Events::exact &&
                 velocity.is_nowhere_above(rule.v_min_m_per_s);
  } else if (state.phase == Phase::slip) {
    is_done = velocity.is_plainly_above(rule.v_min_m_per_s);
    if (is_done) answer = slip(m, spring, direction_of(velocity.now_m_per_s), state);
  } else {
    is_done = true;
    answer = touch_down(m, spring, state);
  }
  if (is_done) {
    state.event_share = 0;
  } else if (is_toothed) {
    answer = toothed(m, spring, state);
  } else {
    answer = rule.events == Events::exact ? walked(m, spring, rule, state) : ticked(m, spring, rule, state);
  }
  state.phase = answer.phase;
  state.last_velocity_m_per_s = velocity.now_m_per_s;
  state.last_step_m = m.step_m();
  return answer;
}

/// The spring softened to what the loop holds. A softened spring keeps its force ratio when the load, and so
/// the softening, changes: unloading alone never slips.
template <typename Spring>
[[gnu::noinline]] Friction capped_rule(const TangentialMotion& motion, const Spring& spring,
                                       const StickRule& rule, double stable_n_per_m,
                                       FrictionState& state) noexcept {
  const double stiffness_n_per_m = spring.load_n * spring.greatest_tangent_per_m();
  // Never so soft that stick would reach without bound (a device without damping).
  const double share =
      stiffness_n_per_m > stable_n_per_m ? std::max(stable_n_per_m / stiffness_n_per_m, 1e-3) : 1;
  const double was = BoundedState(state).softening();
  if (was != share) state.stretch_m = within_huge((was / share) * BoundedState(state).stretch_m());
  state.softening = share;
  Spring soft = spring;
  soft.soften(share);
  Friction answer = plain_rule(motion, soft, rule, state);
  answer.remedied = answer.phase == Phase::stick && share < 1;
  return answer;
}

/// A damper beside a spring that is stiffer, where it stands, than the loop holds. What it adds never passes
/// the static limit; the tick on which stick begins keeps the force of the slip before it.
template <typename Spring>
[[gnu::noinline]] Friction damped_rule(const TangentialMotion& motion, const Spring& spring,
                                       const StickRule& rule, double stable_n_per_m,
                                       FrictionState& state) noexcept {
  constexpr double margin =
      1.5;  // the damper's own sampling takes a part of it (SCIENCE 4: B = 20 gives 3/4)
  const BoundedMotion m(motion);
  Friction answer = plain_rule(motion, spring, rule, state);
  if (answer.phase != Phase::stick || answer.centre_moved) return answer;
  const PlaneVector ratio = spring.ratio_of(answer.stretch_m);
  const double excess_n_per_m = spring.load_n * spring.tangent_per_m(ratio, m.mu_static()) - stable_n_per_m;
  if (!(excess_n_per_m > 0)) return answer;
  PlaneVector force;
  if (rule.remedy.remedy == Remedy::damping) {
    force = PlaneVector(answer.force_n) - margin * excess_n_per_m * m.dt_s() / 2 * m.velocity_m_per_s();
  } else {
    const PlaneVector ahead = spring.ratio_of(answer.stretch_m + m.velocity_m_per_s() * m.dt_s());
    force = -(spring.load_n * spring.hardening(ahead, m.mu_static())) * ahead;
  }
  answer.force_n = shortened(within_huge(force), m.mu_static() * spring.load_n);
  answer.remedied = true;
  return answer;
}

}  // namespace stick_rule_parts

/// One tick of the paper's stick-slip rule, eq. 1-3, on a CircleSpring or an EllipseSpring.
///
/// First touch sticks, unstretched. In stick the spring is stretched by what the skin has moved; it ruptures
/// where its force ratio passes mu_s: above v_min into slip along the velocity, below along the spring, and
/// sticks again at once (Restick::level) or slips on (crossing). Slip gives way to stick where the speed
/// falls to v_min, with the spring at the force of slip as it was written, so that no force jumps.
/// @param motion  any; what is beyond use in it is bounded here (BoundedMotion)
/// @param state   brought up to date
template <typename Spring>
Friction stick_rule(const TangentialMotion& motion, const Spring& spring, const StickRule& rule,
                    FrictionState& state) noexcept {
  if (rule.remedy.remedy != Remedy::none) {
    const double stable =
        stick_remedy_reserve * 2 * rule.remedy.device_damping_n_s_per_m / BoundedMotion(motion).dt_s();
    if (rule.remedy.remedy == Remedy::cap)
      return stick_rule_parts::capped_rule(motion, spring, rule, stable, state);
    if (spring.load_n * spring.greatest_tangent_per_m() > stable)
      return stick_rule_parts::damped_rule(motion, spring, rule, stable, state);
  }
  return stick_rule_parts::plain_rule(motion, spring, rule, state);
}

}  // namespace fingerpad
