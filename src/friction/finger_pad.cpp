#include <numbers>

#include "friction/bounded.hpp"
#include "friction/exponential.hpp"
#include "friction/law_parameters.hpp"
#include "friction/stick_rule.hpp"

namespace fingerpad {
namespace {

constexpr LawParameter cubic_share{"cubic_share",
                                   0,
                                   0,
                                   true,
                                   "c of a third-order spring, force ~ rho (1 - c + c rho^2), rho = 1 on the "
                                   "ellipse; 0 is the linear spring",
                                   1};
constexpr LawParameter mu_rises_below{
    "mu_rises_below_n", 0, 0, true,
    "normal force below which both coefficients rise as (n/this)^(-1/3) [N]; 0 is off, 2 is the paper's"};
constexpr LawParameter finger_pad_parameters[] = {v_min_parameter, stiffness_per_newton_parameter,
                                                  cubic_share, mu_rises_below, device_damping_parameter};

/// The finger pad (paper, figs. 4-8): the stick-slip rule with an ellipse of stick whose axes lie along the
/// finger and across it, and shrink as the finger is raised.
///
/// A profile's axes hold at its own mu_static and scale with the part's, so the stiffness per newton mu/axis
/// is the finger's alone. Ellipse closure (SCIENCE 1, an assumption): anisotropic stiffness, isotropic limit
/// mu_s n. With mu_rises_below_n both spring and limit rise, so the ellipse stays and a change of load never
/// causes slip.
class FingerPad final : public FrictionLaw {
 public:
  FingerPad(const PadProfile& pad, double cubic, double knee_n, const StickRule& rule)
      : lateral45_per_m_(within(pad.mu_static / pad.lateral_axis_m, 1 / huge, huge)),
        longitudinal45_per_m_(within(pad.mu_static / pad.longitudinal_axis_m, 1 / huge, huge)),
        lateral_slope_per_deg_(pad.lateral_slope_per_deg),
        longitudinal_slope_per_deg_(pad.longitudinal_slope_per_deg),
        cubic_share_(cubic),
        knee_n_(knee_n),
        rule_(rule) {}

  Friction tick(const TangentialMotion& motion, FrictionState& state) const noexcept override {
    const BoundedMotion m(motion);
    const double from45_deg = m.inclination_rad() * (180 / std::numbers::pi) - 45;
    EllipseSpring spring;
    spring.load_n = effective_load_n(m.normal_force_n());
    spring.lateral_per_m = lateral45_per_m_ / axis_factor(lateral_slope_per_deg_, from45_deg);
    spring.longitudinal_per_m = longitudinal45_per_m_ / axis_factor(longitudinal_slope_per_deg_, from45_deg);
    spring.cubic_share = cubic_share_;
    spring.along = m.longitudinal();
    return stick_rule(motion, spring, rule_, state);
  }

 private:
  /// a(alpha)/a45; positive for every profile that read_profile accepts.
  static double axis_factor(double slope_per_deg, double from45_deg) noexcept {
    return within(1 - slope_per_deg * from45_deg, 1e-9, huge);
  }

  /// n mu(n)/mu_inf, with mu(n) = mu_inf max(1, (n/knee)^(-1/3)) (power law of a Hertz pad).
  double effective_load_n(double n) const noexcept {
    if (n >= knee_n_) return n;
    return n * inverse_cube_root(n / knee_n_);
  }

  double lateral45_per_m_, longitudinal45_per_m_;
  double lateral_slope_per_deg_, longitudinal_slope_per_deg_;
  double cubic_share_, knee_n_;
  StickRule rule_;
};

/// Any mu serves the assumed pad: only the ratio mu/axis is used, and that is the stiffness.
PadProfile pad_of(const LawSettings& settings, double stiffness_per_m) {
  return settings.profile.value_or(assumed_profile(0.3, stiffness_per_m));
}

/// The profile's axes, scaled by mu_s/mu_profile.
StickAxes pad_axes(const LawSettings& settings, double mu_static, double inclination_rad) {
  const PadProfile pad = pad_of(settings, settings.number(stiffness_per_newton_parameter));
  const double scale = mu_static / pad.mu_static;
  return {scale * pad.lateral_axis_at(inclination_rad), scale * pad.longitudinal_axis_at(inclination_rad)};
}

/// Along the short axis at 45 degrees.
double steepest_rise_per_m(const LawSettings& settings) {
  const PadProfile pad = pad_of(settings, bounded_number(settings, stiffness_per_newton_parameter));
  return pad.mu_static / std::min(pad.lateral_axis_m, pad.longitudinal_axis_m);
}

}  // namespace

LawEntry finger_pad_law() noexcept {
  return {.name = "finger-pad",
          .summary = "the paper's finger pad: stick in an ellipse that shrinks with the finger's angle",
          .parameters = finger_pad_parameters,
          .make = [](const LawSettings& settings) -> std::unique_ptr<FrictionLaw> {
            const PadProfile pad = pad_of(settings, bounded_number(settings, stiffness_per_newton_parameter));
            return std::make_unique<FingerPad>(pad, bounded_number(settings, cubic_share),
                                               bounded_number(settings, mu_rises_below),
                                               stick_rule_of(settings));
          },
          .choices = stick_rule_choices,
          .has_static_limit = true,
          .stick_axes = pad_axes,
          .rise_per_m = steepest_rise_per_m};
}

}  // namespace fingerpad
