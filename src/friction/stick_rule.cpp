#include "friction/stick_rule.hpp"

#include <algorithm>
#include <cmath>

#include "friction/bounded.hpp"
#include "friction/plane_vector.hpp"

namespace fingerpad {
namespace {

/// Rounding of a centre that was set exactly on the limit (mu_d = mu_s) must not break the stick.
constexpr double rounding = 1 + 1e-12;

/// v with its lateral part times `lateral` and its longitudinal part times `longitudinal`.
Vec2 scaled_by_axis(const Vec2& v, const Vec2& along, double lateral, double longitudinal) noexcept {
  const Vec2 across(along.y(), -along.x());
  return across * (lateral * across.dot(v)) + along * (longitudinal * along.dot(v));
}

/// The rho in 0..1 at which rho (1 - c + c rho^2) = share: the real root of the depressed cubic, by sinh.
double rho_at(double share, double c) noexcept {
  if (c <= 0) return share;
  const double p = (1 - c) / c;
  if (p <= 0) return std::cbrt(share);
  const double root = std::sqrt(p / 3);
  return 2 * root * std::sinh(std::asinh(share / c / (2 * root * root * root)) / 3);
}

Friction slip(const TangentialMotion& m, const StickSpring& spring, const Vec2& direction,
              FrictionState& state) noexcept {
  Friction answer;
  answer.phase = Phase::slip;
  answer.force_n = -m.mu_dynamic * spring.load_n * direction;
  state.slip_direction = direction;
  state.slip_force_scale = 1;
  return answer;
}

Friction stick(const TangentialMotion& m, const StickSpring& spring, const Vec2& ratio) noexcept {
  Friction answer;
  answer.phase = Phase::stick;
  answer.from_centre_m = m.from_centre_m;
  const double rho = m.mu_static > 0 ? std::min(1.0, length(ratio) / m.mu_static) : 0;
  answer.force_n = -spring.load_n * (1 - spring.cubic_share * (1 - rho * rho)) * ratio;
  return answer;
}

/// Sets the centre behind S so that the spring gives the slip force (paper, eq. 3).
Friction restick(const TangentialMotion& m, const StickSpring& spring, double force_ratio,
                 const Vec2& direction) noexcept {
  Friction answer;
  answer.phase = Phase::stick;
  answer.centre_moved = true;
  answer.force_n = -force_ratio * spring.load_n * direction;
  const double share = m.mu_static > 0 ? std::min(1.0, force_ratio / m.mu_static) : 0;
  const double linear_ratio = rho_at(share, spring.cubic_share) * m.mu_static;
  answer.from_centre_m = scaled_by_axis(direction * linear_ratio, m.longitudinal, 1 / spring.lateral_per_m,
                                        1 / spring.longitudinal_per_m);
  return answer;
}

/// The rule without remedies.
Friction plain_rule(const TangentialMotion& m, const StickSpring& spring, const RestickRule& rule,
                    FrictionState& state) noexcept {
  const double speed = length(m.velocity_m_per_s);
  const Vec2 towards = direction_of(m.velocity_m_per_s);
  const Phase before = state.phase;
  Friction answer;
  if (before == Phase::free) {
    answer =
        speed > rule.v_min_m_per_s ? slip(m, spring, towards, state) : restick(m, spring, 0, Vec2::Zero());
  } else if (before == Phase::stick) {
    const Vec2 ratio =
        scaled_by_axis(m.from_centre_m, m.longitudinal, spring.lateral_per_m, spring.longitudinal_per_m);
    const bool ruptured = length(ratio) > m.mu_static * rounding;
    // At rest (a tilt, say) the pad gives way in the direction in which the spring pulls.
    const Vec2 direction = speed > 0 ? towards : direction_of(ratio);
    answer = ruptured ? slip(m, spring, direction, state) : stick(m, spring, ratio);
  } else {
    const double written = m.mu_dynamic * state.slip_force_scale;
    const bool slow = speed <= rule.v_min_m_per_s &&
                      (rule.restick == Restick::level || state.last_speed_m_per_s > rule.v_min_m_per_s);
    // A spring that would start beyond its rupture limit (strong vibration) waits for the next tick.
    const bool holds = written <= m.mu_static * rounding;
    const Vec2 direction = speed > 0 ? towards : state.slip_direction;
    answer =
        slow && holds ? restick(m, spring, written, state.slip_direction) : slip(m, spring, direction, state);
  }
  state.phase = answer.phase;
  state.last_speed_m_per_s = speed;
  return answer;
}

/// The rule on a spring that is stiffer than the loop holds. What a damper adds never passes the static
/// limit; the tick on which stick begins keeps the force of the slip before it.
Friction remedied_rule(const TangentialMotion& m, const StickSpring& spring, const RestickRule& rule,
                       double stiffness_n_per_m, double stable_n_per_m, FrictionState& state) noexcept {
  constexpr double margin =
      1.5;  // the damper's own sampling takes a part of it (SCIENCE 4: B = 20 gives 3/4)
  if (rule.remedy.remedy == Remedy::cap) {
    StickSpring soft = spring;
    // Never so soft that stick would reach without bound (a device without damping).
    const double share = std::max(stable_n_per_m / stiffness_n_per_m, 1e-3);
    soft.lateral_per_m *= share;
    soft.longitudinal_per_m *= share;
    Friction answer = plain_rule(m, soft, rule, state);
    answer.remedied = answer.phase == Phase::stick;
    return answer;
  }
  Friction answer = plain_rule(m, spring, rule, state);
  if (answer.phase != Phase::stick || answer.centre_moved) return answer;
  const Vec2 damper =
      rule.remedy.remedy == Remedy::damping
          ? Vec2(margin * (stiffness_n_per_m - stable_n_per_m) * m.dt_s / 2 * m.velocity_m_per_s)
          : Vec2(spring.load_n * scaled_by_axis(m.velocity_m_per_s * m.dt_s, m.longitudinal,
                                                spring.lateral_per_m, spring.longitudinal_per_m));
  answer.force_n = shortened(within_huge(answer.force_n - damper), m.mu_static * spring.load_n);
  answer.remedied = true;
  return answer;
}

}  // namespace

Friction stick_rule(const TangentialMotion& m, const StickSpring& spring, const RestickRule& rule,
                    FrictionState& state) noexcept {
  if (rule.remedy.remedy == Remedy::none) return plain_rule(m, spring, rule, state);
  const double stiffness = spring.load_n * std::max(spring.lateral_per_m, spring.longitudinal_per_m);
  const double stable = stick_remedy_reserve * 2 * rule.remedy.device_damping_n_s_per_m / m.dt_s;
  if (!(stiffness > stable)) return plain_rule(m, spring, rule, state);
  return remedied_rule(m, spring, rule, stiffness, stable, state);
}

}  // namespace fingerpad
