#pragma once

#include <algorithm>
#include <cmath>

#include "friction/bounded.hpp"
#include "friction/law_settings.hpp"
#include "friction/plane_vector.hpp"

namespace fingerpad {

/// The spring of the stick phase on one tick where it is alike in all directions: force ratio q = K d,
/// rupture at |q| = mu_s, so the stick region is a circle of radius mu_s/K.
struct CircleSpring {
  double load_n = 0;  ///< what mu is multiplied by: the normal force, for most laws
  double stiffness_per_m = 1000;

  PlaneVector ratio_of(const PlaneVector& d_m) const noexcept { return stiffness_per_m * d_m; }
  PlaneVector stretch_of(const PlaneVector& ratio) const noexcept { return ratio / stiffness_per_m; }
  double stiffest_per_m() const noexcept { return stiffness_per_m; }
  void soften(double share) noexcept { stiffness_per_m *= share; }
  /// |force| is this times load |q|.
  double hardening(const PlaneVector& /*ratio*/, double /*mu_static*/) const noexcept { return 1; }
  /// |q| at which |force| is `force_ratio` times the load.
  double ratio_at(double force_ratio, double /*mu_static*/) const noexcept { return force_ratio; }
};

/// The root rho in 0..1 of rho (1 - c + c rho^2) = share.
double cubic_spring_rho(double share, double cubic_share) noexcept;

/// The spring of the stick phase where it differs by axis: q = K d with K along the finger's lateral and
/// longitudinal axes, so that the stick region is the ellipse of axes mu_s/K.
struct EllipseSpring {
  double load_n = 0;
  double lateral_per_m = 1000;
  double longitudinal_per_m = 1000;
  double cubic_share = 0;   ///< c: |force| = mu_s load rho (1 - c + c rho^2), rho = |q|/mu_s; 0: linear
  PlaneVector along{0, 1};  ///< unit, the longitudinal axis

  PlaneVector ratio_of(const PlaneVector& d_m) const noexcept {
    return by_axis(d_m, lateral_per_m, longitudinal_per_m);
  }
  PlaneVector stretch_of(const PlaneVector& ratio) const noexcept {
    return by_axis(ratio, 1 / lateral_per_m, 1 / longitudinal_per_m);
  }
  double stiffest_per_m() const noexcept { return std::max(lateral_per_m, longitudinal_per_m); }
  void soften(double share) noexcept {
    lateral_per_m *= share;
    longitudinal_per_m *= share;
  }
  double hardening(const PlaneVector& ratio, double mu_static) const noexcept {
    if (cubic_share == 0) return 1;
    const double rho_square = mu_static > 0 ? ratio.square() / (mu_static * mu_static) : 0;
    return 1 - cubic_share * (1 - std::min(1.0, rho_square));
  }
  double ratio_at(double force_ratio, double mu_static) const noexcept {
    if (cubic_share == 0 || !(mu_static > 0)) return force_ratio;
    return cubic_spring_rho(std::min(1.0, force_ratio / mu_static), cubic_share) * mu_static;
  }

 private:
  PlaneVector by_axis(const PlaneVector& v, double lateral, double longitudinal) const noexcept {
    const double across_v = lateral * (along.y() * v.x() - along.x() * v.y());
    const double along_v = longitudinal * (along.x() * v.x() + along.y() * v.y());
    return {along.y() * across_v + along.x() * along_v, along.y() * along_v - along.x() * across_v};
  }
};

/// When stick begins.
struct RestickRule {
  double v_min_m_per_s = 0.1;
  Restick restick = Restick::level;
  StickRemedy remedy{};
};

namespace stick_rule_parts {

/// Rounding of a centre that was set exactly on the limit (mu_d = mu_s) must not break the stick.
inline constexpr double rounding = 1 + 1e-12;

template <typename Spring>
inline Friction slip(const BoundedMotion& m, const Spring& spring, const PlaneVector& direction,
                     FrictionState& state) noexcept {
  Friction answer;
  answer.phase = Phase::slip;
  answer.force_n = (-m.mu_dynamic() * spring.load_n) * direction;
  state.slip_direction = direction;
  state.slip_force_scale = 1;
  return answer;
}

template <typename Spring>
inline Friction stick(const BoundedMotion& m, const Spring& spring, const PlaneVector& ratio) noexcept {
  Friction answer;
  answer.phase = Phase::stick;
  answer.from_centre_m = m.from_centre_m();
  answer.force_n = -(spring.load_n * spring.hardening(ratio, m.mu_static())) * ratio;
  return answer;
}

/// Sets the centre behind S so that the spring gives the slip force (paper, eq. 3).
template <typename Spring>
inline Friction restick(const BoundedMotion& m, const Spring& spring, double force_ratio,
                        const PlaneVector& direction) noexcept {
  Friction answer;
  answer.phase = Phase::stick;
  answer.centre_moved = true;
  answer.force_n = (-force_ratio * spring.load_n) * direction;
  answer.from_centre_m = spring.stretch_of(spring.ratio_at(force_ratio, m.mu_static()) * direction);
  return answer;
}

/// The rule without remedies.
template <typename Spring>
[[gnu::always_inline]] inline Friction plain_rule(const TangentialMotion& motion, const Spring& spring,
                                                  const RestickRule& rule, FrictionState& state) noexcept {
  const BoundedMotion m(motion);
  const BoundedState last(state);
  const Polar v = polar(m.velocity_m_per_s());
  Friction answer;
  if (state.phase == Phase::stick) {
    const PlaneVector ratio = spring.ratio_of(m.from_centre_m());
    if (!is_longer(ratio, m.mu_static() * rounding)) {
      answer = stick(m, spring, ratio);
    } else {
      // At rest (a tilt, say) the pad gives way in the direction in which the spring pulls.
      answer = slip(m, spring, v.length > 0 ? v.direction : direction_of(ratio), state);
    }
  } else if (state.phase == Phase::slip) {
    const double written = m.mu_dynamic() * last.slip_force_scale();
    const bool slow = v.length <= rule.v_min_m_per_s &&
                      (rule.restick == Restick::level || last.last_speed_m_per_s() > rule.v_min_m_per_s);
    // A spring that would start beyond its rupture limit (strong vibration) waits for the next tick.
    if (slow && written <= m.mu_static() * rounding) {
      answer = restick(m, spring, written, last.slip_direction());
    } else {
      answer = slip(m, spring, v.length > 0 ? v.direction : last.slip_direction(), state);
    }
  } else {
    answer = v.length > rule.v_min_m_per_s ? slip(m, spring, v.direction, state)
                                           : restick(m, spring, 0, PlaneVector());
  }
  state.phase = answer.phase;
  state.last_speed_m_per_s = v.length;
  return answer;
}

/// The rule on a spring that is stiffer than the loop holds. What a damper adds never passes the static
/// limit; the tick on which stick begins keeps the force of the slip before it.
template <typename Spring>
[[gnu::noinline]] Friction remedied_rule(const TangentialMotion& motion, const Spring& spring,
                                         const RestickRule& rule, double stable_n_per_m,
                                         FrictionState& state) noexcept {
  constexpr double margin =
      1.5;  // the damper's own sampling takes a part of it (SCIENCE 4: B = 20 gives 3/4)
  const BoundedMotion m(motion);
  const double stiffness_n_per_m = spring.load_n * spring.stiffest_per_m();
  if (rule.remedy.remedy == Remedy::cap) {
    Spring soft = spring;
    // Never so soft that stick would reach without bound (a device without damping).
    soft.soften(std::max(stable_n_per_m / stiffness_n_per_m, 1e-3));
    Friction answer = plain_rule(motion, soft, rule, state);
    answer.remedied = answer.phase == Phase::stick;
    return answer;
  }
  Friction answer = plain_rule(motion, spring, rule, state);
  if (answer.phase != Phase::stick || answer.centre_moved) return answer;
  const PlaneVector damper =
      rule.remedy.remedy == Remedy::damping
          ? PlaneVector(margin * (stiffness_n_per_m - stable_n_per_m) * m.dt_s() / 2 * m.velocity_m_per_s())
          : PlaneVector(spring.load_n * spring.ratio_of(m.velocity_m_per_s() * m.dt_s()));
  answer.force_n = shortened(within_huge(answer.force_n - damper), m.mu_static() * spring.load_n);
  answer.remedied = true;
  return answer;
}

}  // namespace stick_rule_parts

/// One tick of the paper's stick-slip rule, eq. 1-3, on a CircleSpring or an EllipseSpring.
///
/// Order of the tests: first touch (above v_min slip, else stick with the centre at the contact point); in
/// stick, rupture before the force is written, so that |force| <= mu_s load; in slip, restick, at which the
/// centre is set so that the spring gives the force of the last slip tick as it was written.
/// @param motion  any; bounded() is applied here
/// @param state   phase, slip direction and speed are brought up to date
template <typename Spring>
Friction stick_rule(const TangentialMotion& motion, const Spring& spring, const RestickRule& rule,
                    FrictionState& state) noexcept {
  if (rule.remedy.remedy != Remedy::none) {
    const double stable =
        stick_remedy_reserve * 2 * rule.remedy.device_damping_n_s_per_m / BoundedMotion(motion).dt_s();
    if (spring.load_n * spring.stiffest_per_m() > stable) {
      return stick_rule_parts::remedied_rule(motion, spring, rule, stable, state);
    }
  }
  return stick_rule_parts::plain_rule(motion, spring, rule, state);
}

}  // namespace fingerpad
