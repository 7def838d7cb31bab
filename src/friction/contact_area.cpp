#include "friction/contact_area.hpp"

#include <numbers>

#include "friction/bounded.hpp"
#include "friction/exponential.hpp"
#include "friction/law_parameters.hpp"
#include "friction/stick_rule.hpp"

namespace fingerpad {
namespace {

constexpr LawParameter pad_radius{
    "pad_radius_m", 0.008, 0, false,
    "R: the pad's radius where it touches [m]; assumed. Matters with adhesion only"};
constexpr LawParameter adhesion{"adhesion_j_per_m2", 0, 0, true,
                                "gamma: work of adhesion [J/m^2]; 0 is Hertz"};
constexpr LawParameter contact_area_parameters[] = {v_min_parameter, stiffness_per_newton_parameter,
                                                    pad_radius, adhesion, device_damping_parameter};

/// K a^3/R of the contact [N]: what the contact radius depends on, without the pad's modulus.
double cubed_radius_n(double normal_force_n, double w_n) noexcept {
  return normal_force_n + w_n + std::sqrt(std::max(0.0, w_n * (2 * normal_force_n + w_n)));
}

/// Friction that goes with the contact area, after the idea the paper cites from Chen 1997, with JKR's area:
/// limits tau_s pi a^2 and tau_d pi a^2, so the limit goes with n^(2/3), and adhesion leaves one at n -> 0.
///
/// tau is such that the coefficients are mu_s and mu_d at n = 1 N; so only the ratio of areas to that at 1 N
/// counts, and the modulus drops out. The spring goes with the area too: the region of stick is a circle of
/// radius mu_s/k_f at any load. Deviation: tension up to the pull-off is computed (JkrPad), not displayed.
class ContactArea final : public FrictionLaw {
 public:
  ContactArea(double adhesion_load_n, double stiffness_per_m, const StickRule& rule)
      : w_n_(adhesion_load_n),
        per_one_newton_(1 / cubed_radius_n(1, adhesion_load_n)),
        stiffness_per_m_(stiffness_per_m),
        rule_(rule) {}

  Friction tick(const TangentialMotion& motion, FrictionState& state) const noexcept override {
    const double cubed_ratio = cubed_radius_n(BoundedMotion(motion).normal_force_n(), w_n_) * per_one_newton_;
    const double area_ratio = cubed_ratio * inverse_cube_root(cubed_ratio);
    return stick_rule(motion, CircleSpring{area_ratio, stiffness_per_m_}, rule_, state);
  }

 private:
  double w_n_, per_one_newton_;
  double stiffness_per_m_;
  StickRule rule_;
};

/// Without adhesion mu falls as n^(-1/3) from 1 N on.
double mu_raise(double load_n) {
  return std::cbrt(load_n);
}

}  // namespace

double JkrPad::adhesion_load_n() const noexcept {
  return 3 * std::numbers::pi * adhesion_j_per_m2 * radius_m;
}

double JkrPad::contact_radius_m(double normal_force_n) const noexcept {
  const double k_pa = 4 * modulus_pa / 3;
  return std::cbrt(radius_m / k_pa * cubed_radius_n(normal_force_n, adhesion_load_n()));
}

double JkrPad::pull_off_n() const noexcept {
  return adhesion_load_n() / 2;
}

LawEntry contact_area_law() noexcept {
  return {.name = "contact-area",
          .summary = "after Chen et al. 1997: limits that go with the JKR contact area; mu holds at 1 N",
          .parameters = contact_area_parameters,
          .make = [](const LawSettings& settings) -> std::unique_ptr<FrictionLaw> {
            const JkrPad pad{bounded_number(settings, pad_radius), 1, bounded_number(settings, adhesion)};
            return std::make_unique<ContactArea>(within(pad.adhesion_load_n(), 0, huge),
                                                 bounded_number(settings, stiffness_per_newton_parameter),
                                                 stick_rule_of(settings));
          },
          .choices = stick_rule_choices,
          .has_static_limit = true,
          .mu_raise = mu_raise};
}

}  // namespace fingerpad
