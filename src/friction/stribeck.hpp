#pragma once

#include <cmath>

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
struct StribeckBristle {
  double sigma0_n_per_m, sigma1_n_s_per_m, sigma2_n_s_per_m, stribeck_speed_m_per_s;

  explicit StribeckBristle(const LawSettings& settings)
      : sigma0_n_per_m(bounded_number(settings, fixed_stiffness_parameter)),
        sigma1_n_s_per_m(bounded_number(settings, bristle_damping_parameter)),
        sigma2_n_s_per_m(bounded_number(settings, viscous_parameter)),
        stribeck_speed_m_per_s(bounded_number(settings, stribeck_speed_parameter)) {}

  /// g(v)/sigma_0: deflection of steady sliding; g = F_c + (F_s - F_c) e^(-(v/v_s)^2), F = mu n.
  double steady_deflection_m(const TangentialMotion& m, double speed_m_per_s) const noexcept {
    const double ratio = speed_m_per_s / stribeck_speed_m_per_s;
    const double square = ratio * ratio;
    const double fallen = square < 40 ? std::exp(-square) : 0;
    const double mu = m.mu_dynamic + (m.mu_static - m.mu_dynamic) * fallen;
    return mu * m.normal_force_n / sigma0_n_per_m;
  }

  /// Force on the finger: -(sigma_0 z + sigma_1 z' + sigma_2 v).
  Vec2 force_n(const TangentialMotion& m, const Vec2& z_m, const Vec2& stretch_m) const noexcept {
    return -sigma0_n_per_m * z_m - (sigma1_n_s_per_m / m.dt_s) * stretch_m -
           sigma2_n_s_per_m * m.velocity_m_per_s;
  }
};

}  // namespace fingerpad
