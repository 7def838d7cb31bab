#include "friction/bristle.hpp"
#include "friction/law_parameters.hpp"

namespace fingerpad {
namespace {

constexpr LawParameter stick_damping{"stick_damping_n_s_per_m", 0, 0, true,
                                     "B: damping beside the stick spring [N s/m]"};
constexpr LawParameter kikuuwe_parameters[] = {fixed_stiffness_parameter, stick_damping};

/// Kikuuwe, Takesue, Sano, Mochiyama & Fujimoto 2006, impedance form: Coulomb friction behind a spring and
/// damper, stepped by backward Euler: e* = e + dx; f = sat_F(K e* + B dx/T); e <- (f + (B/T) e)/(K + B/T). F
/// = mu_d n.
class Kikuuwe final : public FrictionLaw {
 public:
  Kikuuwe(double stiffness_n_per_m, double damping_n_s_per_m)
      : stiffness_n_per_m_(stiffness_n_per_m), damping_n_s_per_m_(damping_n_s_per_m) {}

  Friction tick(const TangentialMotion& motion, FrictionState& state) const noexcept override {
    if (state.phase == Phase::free) return bristle_at_rest(state);
    const BoundedMotion m(motion);
    const double limit_n = m.mu_dynamic() * m.normal_force_n();
    const double per_step = damping_n_s_per_m_ > 0 ? damping_n_s_per_m_ / m.dt_s() : 0;
    const PlaneVector e = BoundedState(state).stretch_m();
    const PlaneVector wanted = stiffness_n_per_m_ * (e + m.step_m()) + per_step * m.step_m();
    const PlaneVector f = shortened(wanted, limit_n);
    const PlaneVector next = (f + per_step * e) * (1 / (stiffness_n_per_m_ + per_step));
    // One that stands on the limit sticks there: rounding must not make it slip at rest.
    const bool saturated = is_longer(wanted, limit_n * (1 + 1e-12));
    return bristle_answer(-f, next, saturated ? Phase::slip : Phase::stick, state);
  }

 private:
  double stiffness_n_per_m_, damping_n_s_per_m_;
};

}  // namespace

LawEntry kikuuwe_law() noexcept {
  return {.name = "kikuuwe",
          .summary = "Kikuuwe et al. 2006: Coulomb friction behind a spring and damper; mu_dynamic only",
          .parameters = kikuuwe_parameters,
          .make = [](const LawSettings& settings) -> std::unique_ptr<FrictionLaw> {
            return std::make_unique<Kikuuwe>(bounded_number(settings, fixed_stiffness_parameter),
                                             bounded_number(settings, stick_damping));
          }};
}

}  // namespace fingerpad
