#include "friction/bristle.hpp"
#include "friction/law_parameters.hpp"
#include "friction/stick_walk.hpp"

namespace fingerpad {
namespace {

constexpr LawParameter slip_damping{"slip_damping_n_s_per_m", 0, 0, true,
                                    "B of the viscous slip force [N s/m]; 0 stands for mu_d n/v_min, the "
                                    "slip force of the other laws at v_min"};
/// The other laws' v_min with a least value: B = mu_d n/v_min grows without bound as v_min vanishes.
constexpr LawParameter v_min{v_min_parameter.key, v_min_parameter.default_value, 1e-4, true,
                             v_min_parameter.meaning};
constexpr LawParameter salcudean_vlaar_parameters[] = {v_min, fixed_stiffness_parameter, slip_damping};

/// A viscous slide, f = B v, in newtons. Stick begins at v_min, or where B v has fallen to mu_s n.
struct ViscousSlide {
  double mu_static, damping_n_s_per_m;
  double restick_m_per_s;
  bool sticks_at_once = true;

  double force_ratio(double speed_m_per_s) const noexcept { return damping_n_s_per_m * speed_m_per_s; }
};

/// Salcudean & Vlaar 1997: a stick spring released at mu_s n, and viscous slip f = B v.
///
/// Stick begins at |v| <= v_min, with the spring set to the viscous force of that moment (deviation: the
/// centre's place is not in SCIENCE; this makes the force continuous). |f| may exceed mu_s n in fast slip: it
/// is viscous.
class SalcudeanVlaar final : public FrictionLaw {
 public:
  SalcudeanVlaar(double v_min_m_per_s, double stiffness_n_per_m, double damping_n_s_per_m, Events events)
      : v_min_m_per_s_(v_min_m_per_s),
        stiffness_n_per_m_(stiffness_n_per_m),
        damping_n_s_per_m_(damping_n_s_per_m),
        events_(events) {}

  Friction tick(const TangentialMotion& motion, FrictionState& state) const noexcept override {
    if (state.phase == Phase::free) return touch_down(motion, state);
    const BoundedMotion m(motion);
    const BoundedState last(state);
    const TickVelocity velocity{last.last_velocity_m_per_s(), m.velocity_m_per_s()};
    const double limit_n = m.mu_static() * m.normal_force_n();
    const CircleSpring spring{1, stiffness_n_per_m_};
    const double scaled = damping(m) * (state.phase == Phase::slip ? last.slip_force_scale() : 1);
    const double restick = scaled > 0 ? std::min(v_min_m_per_s_, limit_n / scaled) : v_min_m_per_s_;
    const PlaneVector pull_n = spring.ratio_of(last.stretch_m() + m.step_m());
    const bool nothing_happens = state.phase == Phase::stick
                                     ? !is_longer(pull_n, limit_n * (1 + 1e-12)) && !(state.event_share > 0.5)
                                     : velocity.is_plainly_above(restick);
    StickEnd end;
    if (nothing_happens) {
      end.phase = state.phase;
      end.ratio = pull_n;
    } else if (events_ == Events::exact) {
      end = walked(m, spring, ViscousSlide{limit_n, damping(m), restick}, velocity, state);
    } else {
      end = tested_at_tick(m, last, limit_n, restick, state.phase);
    }
    state.event_share = end.last_event;
    state.last_velocity_m_per_s = m.velocity_m_per_s();
    state.last_step_m = m.step_m();
    return written(m, end, state);
  }

 private:
  static Friction touch_down(const TangentialMotion& motion, FrictionState& state) noexcept {
    Friction answer = bristle_at_rest(state);
    state.last_velocity_m_per_s = BoundedMotion(motion).velocity_m_per_s();
    return answer;
  }

  [[gnu::noinline]] static StickEnd walked(const BoundedMotion& m, const CircleSpring& spring,
                                           const ViscousSlide& slide, const TickVelocity& velocity,
                                           const FrictionState& state) noexcept {
    const BoundedState last(state);
    StickWay way;
    way.ratio = spring.ratio_of(last.stretch_m());
    way.before = spring.ratio_of(last.last_step_m());
    way.now = spring.ratio_of(m.step_m());
    way.velocity = velocity;
    way.direction_before =
        state.phase == Phase::slip ? last.slip_direction() : direction_of(velocity.before_m_per_s);
    way.direction_now = direction_of(velocity.now_m_per_s);
    if (!(way.direction_now.square() > 0)) way.direction_now = way.direction_before;
    way.slipped_scale = last.slip_force_scale();
    return StickWalk(spring, slide, way).run(state.phase, last.event_share());
  }

  /// Rupture and restick at ticks only: the force at restick is the viscous one of that tick.
  StickEnd tested_at_tick(const BoundedMotion& m, const BoundedState& last, double limit_n, double restick,
                          Phase before) const noexcept {
    StickEnd end;
    if (before == Phase::stick) {
      end.ratio = stiffness_n_per_m_ * (last.stretch_m() + m.step_m());
      if (is_longer(end.ratio, limit_n * (1 + 1e-12))) {
        end.phase = Phase::slip;
        end.ruptures = 1;
      }
    } else if (!is_longer(m.velocity_m_per_s(), restick)) {
      end.ratio = (damping(m) * last.slip_force_scale()) * m.velocity_m_per_s();
      end.centre_moved = true;
    } else {
      end.phase = Phase::slip;
    }
    return end;
  }

  Friction written(const BoundedMotion& m, const StickEnd& end, FrictionState& state) const noexcept {
    Friction answer;
    answer.phase = state.phase = end.phase;
    answer.ruptures = end.ruptures;
    PlaneVector pull_n = end.ratio;
    if (end.phase == Phase::slip) {
      pull_n = damping(m) * m.velocity_m_per_s();
      if (pull_n.square() > 0) state.slip_direction = direction_of(pull_n);
      state.slip_force_scale = 1;
    }
    state.stretch_m = pull_n / stiffness_n_per_m_;
    answer.force_n = -pull_n;
    if (end.phase == Phase::stick) {
      answer.stretch_m = state.stretch_m;
      answer.centre_moved = end.centre_moved;
    }
    return answer;
  }

  double damping(const BoundedMotion& m) const noexcept {
    if (damping_n_s_per_m_ > 0) return damping_n_s_per_m_;
    return m.mu_dynamic() * m.normal_force_n() / v_min_m_per_s_;
  }

  double v_min_m_per_s_, stiffness_n_per_m_, damping_n_s_per_m_;
  Events events_;
};

}  // namespace

LawEntry salcudean_vlaar_law() noexcept {
  return {.name = "salcudean-vlaar",
          .summary = "Salcudean & Vlaar 1997: stick spring, viscous slip",
          .parameters = salcudean_vlaar_parameters,
          .make = [](const LawSettings& settings) -> std::unique_ptr<FrictionLaw> {
            return std::make_unique<SalcudeanVlaar>(std::max(v_min_m_per_s(settings), v_min.min),
                                                    bounded_number(settings, fixed_stiffness_parameter),
                                                    bounded_number(settings, slip_damping), settings.events);
          },
          .choices = rupture_choices,
          .has_static_limit = true};
}

}  // namespace fingerpad
