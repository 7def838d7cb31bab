#include "friction/bounded.hpp"
#include "friction/law_parameters.hpp"
#include "friction/plane_vector.hpp"

namespace fingerpad {
namespace {

constexpr LawParameter slip_damping{"slip_damping_n_s_per_m", 0, 0, true,
                                    "B of the viscous slip force [N s/m]; 0 stands for mu_d n/v_min, the "
                                    "slip force of the other laws at v_min"};
constexpr LawParameter parameters[] = {v_min_parameter, fixed_stiffness_parameter, slip_damping};

/// Salcudean & Vlaar 1997: a stick spring released at mu_s n, and viscous slip f = B v.
///
/// Stick begins at |v| <= v_min, with the spring set to the viscous force of that tick (deviation: the
/// centre's place is not in SCIENCE; this makes the force continuous). |f| may exceed mu_s n in fast slip: it
/// is viscous.
class SalcudeanVlaar final : public FrictionLaw {
 public:
  SalcudeanVlaar(double v_min_m_per_s, double stiffness_n_per_m, double damping_n_s_per_m)
      : v_min_m_per_s_(v_min_m_per_s),
        stiffness_n_per_m_(stiffness_n_per_m),
        damping_n_s_per_m_(damping_n_s_per_m) {}

  Friction tick(const TangentialMotion& motion, FrictionState& state) const noexcept override {
    const Phase before = state.phase;
    const BoundedMotion m(motion);
    const Polar v = polar(m.velocity_m_per_s());
    const double limit_n = m.mu_static() * m.normal_force_n();
    const PlaneVector viscous = (-damping(m) * BoundedState(state).slip_force_scale()) * m.velocity_m_per_s();
    Friction answer;
    if (before == Phase::stick) {
      answer.force_n = -stiffness_n_per_m_ * m.from_centre_m();
      answer.from_centre_m = m.from_centre_m();
      answer.phase = is_longer(answer.force_n, limit_n * (1 + 1e-12)) ? Phase::slip : Phase::stick;
    } else if (v.length <= v_min_m_per_s_ && (before == Phase::free || !is_longer(viscous, limit_n))) {
      answer.phase = Phase::stick;
      answer.centre_moved = true;
      if (before == Phase::slip) answer.force_n = viscous;
      answer.from_centre_m = -answer.force_n / stiffness_n_per_m_;
    }
    if (answer.phase == Phase::slip) {
      answer.from_centre_m = PlaneVector();
      answer.force_n = -damping(m) * m.velocity_m_per_s();
      if (v.length > 0) state.slip_direction = v.direction;
      state.slip_force_scale = 1;
    }
    state.phase = answer.phase;
    state.last_speed_m_per_s = v.length;
    return answer;
  }
  bool reads_step() const noexcept override { return false; }

 private:
  double damping(const BoundedMotion& m) const noexcept {
    if (damping_n_s_per_m_ > 0) return damping_n_s_per_m_;
    return m.mu_dynamic() * m.normal_force_n() / std::max(v_min_m_per_s_, 1e-9);
  }

  double v_min_m_per_s_, stiffness_n_per_m_, damping_n_s_per_m_;
};

}  // namespace

LawEntry salcudean_vlaar_law() noexcept {
  return {"salcudean-vlaar", "Salcudean & Vlaar 1997: stick spring, viscous slip", parameters,
          [](const LawSettings& settings) -> std::unique_ptr<FrictionLaw> {
            return std::make_unique<SalcudeanVlaar>(v_min_m_per_s(settings),
                                                    bounded_number(settings, fixed_stiffness_parameter),
                                                    bounded_number(settings, slip_damping));
          }};
}

}  // namespace fingerpad
