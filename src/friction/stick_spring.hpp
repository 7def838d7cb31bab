#pragma once

#include <algorithm>

#include "friction/plane_vector.hpp"

namespace fingerpad {

/// The spring of the stick phase on one tick where it is alike in all directions: force ratio q = K z of the
/// stretch z, rupture at |q| = mu_s, so the stick region is a circle of radius mu_s/K.
struct CircleSpring {
  double load_n = 0;  ///< what mu is multiplied by: the normal force, for most laws
  double stiffness_per_m = 1000;

  PlaneVector ratio_of(const PlaneVector& stretch_m) const noexcept { return stiffness_per_m * stretch_m; }
  PlaneVector stretch_of(const PlaneVector& ratio) const noexcept { return ratio / stiffness_per_m; }
  void soften(double share) noexcept { stiffness_per_m *= share; }
  /// |force| is this times load |q|.
  double hardening(const PlaneVector& /*ratio*/, double /*mu_static*/) const noexcept { return 1; }
  /// |q| at which |force| is `force_ratio` times the load.
  double ratio_at(double force_ratio, double /*mu_static*/) const noexcept { return force_ratio; }
  /// Change of |force|/load per metre of stretch, at q and at its greatest (on the rim).
  double tangent_per_m(const PlaneVector& /*ratio*/, double /*mu_static*/) const noexcept {
    return stiffness_per_m;
  }
  double greatest_tangent_per_m() const noexcept { return stiffness_per_m; }
};

/// The root rho in 0..1 of rho (1 - c + c rho^2) = share.
double cubic_spring_rho(double share, double cubic_share) noexcept;

/// The spring of the stick phase where it differs by axis: q = K z with K along the finger's lateral and
/// longitudinal axes, so that the stick region is the ellipse of axes mu_s/K.
struct EllipseSpring {
  double load_n = 0;
  double lateral_per_m = 1000;
  double longitudinal_per_m = 1000;
  double cubic_share = 0;   ///< c: |force| = mu_s load rho (1 - c + c rho^2), rho = |q|/mu_s; 0: linear
  PlaneVector along{0, 1};  ///< unit, the longitudinal axis

  PlaneVector ratio_of(const PlaneVector& stretch_m) const noexcept {
    return by_axis(stretch_m, lateral_per_m, longitudinal_per_m);
  }
  PlaneVector stretch_of(const PlaneVector& ratio) const noexcept {
    return by_axis(ratio, 1 / lateral_per_m, 1 / longitudinal_per_m);
  }
  void soften(double share) noexcept {
    lateral_per_m *= share;
    longitudinal_per_m *= share;
  }
  double hardening(const PlaneVector& ratio, double mu_static) const noexcept {
    if (cubic_share == 0) return 1;
    return 1 - cubic_share * (1 - rho_square(ratio, mu_static));
  }
  double ratio_at(double force_ratio, double mu_static) const noexcept {
    if (cubic_share == 0 || !(mu_static > 0)) return force_ratio;
    return cubic_spring_rho(std::min(1.0, force_ratio / mu_static), cubic_share) * mu_static;
  }
  /// Of the stiffer axis: d/drho of rho (1 - c + c rho^2).
  double tangent_per_m(const PlaneVector& ratio, double mu_static) const noexcept {
    const double stiffest = std::max(lateral_per_m, longitudinal_per_m);
    if (cubic_share == 0) return stiffest;
    return stiffest * (1 - cubic_share * (1 - 3 * rho_square(ratio, mu_static)));
  }
  double greatest_tangent_per_m() const noexcept {
    return (1 + 2 * cubic_share) * std::max(lateral_per_m, longitudinal_per_m);
  }

 private:
  static double rho_square(const PlaneVector& ratio, double mu_static) noexcept {
    return mu_static > 0 ? std::min(1.0, ratio.square() / (mu_static * mu_static)) : 0;
  }

  PlaneVector by_axis(const PlaneVector& v, double lateral, double longitudinal) const noexcept {
    const double across_v = lateral * (along.y() * v.x() - along.x() * v.y());
    const double along_v = longitudinal * (along.x() * v.x() + along.y() * v.y());
    return {along.y() * across_v + along.x() * along_v, along.y() * along_v - along.x() * across_v};
  }
};

}  // namespace fingerpad
