#include "friction/bounded.hpp"
#include "friction/law_parameters.hpp"
#include "friction/stick_rule.hpp"

namespace fingerpad {
namespace {

constexpr LawParameter stick_slip_parameters[] = {v_min_parameter, stiffness_per_newton_parameter,
                                                  device_damping_parameter};

/// The paper's basic model: a circle of stick of radius mu_s/k_f, eq. 1-3.
class StickSlip final : public FrictionLaw {
 public:
  StickSlip(double stiffness_per_m, const StickRule& rule) : stiffness_per_m_(stiffness_per_m), rule_(rule) {}

  Friction tick(const TangentialMotion& motion, FrictionState& state) const noexcept override {
    const double load_n = BoundedMotion(motion).normal_force_n();
    return stick_rule(motion, CircleSpring{load_n, stiffness_per_m_}, rule_, state);
  }

 private:
  double stiffness_per_m_;
  StickRule rule_;
};

StickAxes circle(const LawSettings& settings, double mu_static, double) {
  const double radius_m = mu_static / settings.number(stiffness_per_newton_parameter);
  return {radius_m, radius_m};
}

}  // namespace

LawEntry stick_slip_law() noexcept {
  return {.name = "stick-slip",
          .summary = "the paper's basic model: stick in a circle, Coulomb slip",
          .parameters = stick_slip_parameters,
          .make = [](const LawSettings& settings) -> std::unique_ptr<FrictionLaw> {
            return std::make_unique<StickSlip>(bounded_number(settings, stiffness_per_newton_parameter),
                                               stick_rule_of(settings));
          },
          .choices = stick_rule_choices,
          .has_static_limit = true,
          .stick_axes = circle};
}

}  // namespace fingerpad
