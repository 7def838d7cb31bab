#pragma once

#include "friction/law.hpp"

namespace fingerpad {

/// The spring of the stick phase on one tick, per newton of load: force ratio q = K d with K along the
/// finger's lateral and longitudinal axes; it ruptures at |q| = mu_s, so the stick region is the ellipse of
/// axes mu_s/K.
struct StickSpring {
  double load_n =
      0;  ///< what the coefficients of friction are multiplied by: the normal force, for most laws
  double lateral_per_m = 1000;
  double longitudinal_per_m = 1000;
  double cubic_share =
      0;  ///< c: |force| = mu_s load rho (1 - c + c rho^2), rho = |q|/mu_s; 0 is the linear spring
};

/// When stick begins.
struct RestickRule {
  double v_min_m_per_s = 0.1;
  Restick restick = Restick::level;
  StickRemedy remedy{};
};

/// One tick of the paper's stick-slip rule, eq. 1-3, on a spring that may differ by axis.
///
/// Order of the tests: first touch (above v_min slip, else stick with the centre at the contact point); in
/// stick, rupture before the force is written, so that |force| <= mu_s load; in slip, restick, at which the
/// centre is set so that the spring gives the force of the last slip tick as it was written.
/// @param m      bounded()
/// @param state  bounded by bound(); phase, slip direction and speed are brought up to date
Friction stick_rule(const TangentialMotion& m, const StickSpring& spring, const RestickRule& rule,
                    FrictionState& state) noexcept;

}  // namespace fingerpad
