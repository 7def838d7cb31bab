#pragma once

#include <cmath>

#include "friction/exponential.hpp"
#include "friction/law_parameters.hpp"

namespace fingerpad {

/// Parameters that the bristle laws with a Stribeck curve share.
inline constexpr LawParameter stribeck_speed_parameter{
    "stribeck_speed_m_per_s", 0.01, 0, false,
    "v_s: where the limit has fallen from mu_s towards mu_d by 1/e [m/s]; Canudas de Wit 1995 uses 0.001"};
inline constexpr LawParameter bristle_damping_parameter{
    "bristle_damping_n_s_per_m", 0, 0, true, "sigma_1: force per speed of the bristle's stretch [N s/m]"};
inline constexpr LawParameter viscous_parameter{"viscous_n_s_per_m", 0, 0, true,
                                                "sigma_2: viscous friction [N s/m]"};

/// Bristle stiffness, damping and viscous friction, and the Stribeck speed.
class StribeckBristle {
 public:
  explicit StribeckBristle(const LawSettings& settings)
      : sigma0_n_per_m_(bounded_number(settings, fixed_stiffness_parameter)),
        sigma1_n_s_per_m_(bounded_number(settings, bristle_damping_parameter)),
        sigma2_n_s_per_m_(bounded_number(settings, viscous_parameter)),
        per_sigma0_m_per_n_(1 / sigma0_n_per_m_),
        per_stribeck_speed_square_(1 / std::pow(bounded_number(settings, stribeck_speed_parameter), 2)) {}

  /// mu_s n/sigma_0: where the bristle is shortened to when the load falls.
  double longest_deflection_m(const BoundedMotion& m) const noexcept {
    return m.mu_static() * m.normal_force_n() * per_sigma0_m_per_n_;
  }

  /// g(v)/sigma_0: deflection of steady sliding; g = F_c + (F_s - F_c) e^(-(v/v_s)^2), F = mu n.
  double steady_deflection_m(const BoundedMotion& m) const noexcept {
    const PlaneVector v = m.velocity_m_per_s();
    const double square = (v.square()) * per_stribeck_speed_square_;
    double mu = m.mu_dynamic();
    if (square < 40) mu += (m.mu_static() - m.mu_dynamic()) * exp_of_minus(square);
    return mu * m.normal_force_n() * per_sigma0_m_per_n_;
  }

  /// Force on the finger: -(sigma_0 z + sigma_1 z' + sigma_2 v).
  PlaneVector force_n(const BoundedMotion& m, const PlaneVector& z_m,
                      const PlaneVector& stretch_m) const noexcept {
    PlaneVector force = -sigma0_n_per_m_ * z_m;
    if (sigma1_n_s_per_m_ > 0) force = force - (sigma1_n_s_per_m_ / m.dt_s()) * stretch_m;
    if (sigma2_n_s_per_m_ > 0) force = force - sigma2_n_s_per_m_ * m.velocity_m_per_s();
    return force;
  }

 private:
  double sigma0_n_per_m_, sigma1_n_s_per_m_, sigma2_n_s_per_m_;
  double per_sigma0_m_per_n_, per_stribeck_speed_square_;
};

}  // namespace fingerpad
