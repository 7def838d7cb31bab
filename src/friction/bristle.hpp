#pragma once

#include <cmath>

#include "friction/bounded.hpp"
#include "friction/plane_vector.hpp"

namespace fingerpad {

/// 1 - e^(-x) for x >= 0, to 1e-13 of itself; several times faster than expm1.
inline double one_less_exp(double x) noexcept {
  if (x > 1e-3) return x < 40 ? 1 - std::exp(-x) : 1;
  return x * (1 - x / 2 * (1 - x / 3 * (1 - x / 4)));
}

/// Dahl's equation dz = dx - |dx| z/z_c over one straight step, solved exactly, so that no step is too long.
/// @pre z_c_m > 0, moved_m = |step|
inline Vec2 dahl_step(const Vec2& z_m, const Vec2& step_m, double moved_m, double z_c_m) noexcept {
  const double x = moved_m / z_c_m;
  if (!(x > 0)) return z_m + step_m;
  // z_s + (z - z_s) e^(-x) with z_s = z_c dx/|dx|, written so that a tiny step loses no digits.
  const double yielded = one_less_exp(x);
  return z_m + step_m * (yielded / x) - z_m * yielded;
}

/// Slip is where more of a step is plastic than elastic; at rest a bristle sticks.
inline Phase bristle_phase(const Vec2& stretch_m, double moved_m) noexcept {
  return 4 * stretch_m.squaredNorm() < moved_m * moved_m ? Phase::slip : Phase::stick;
}

/// Brings the state up to date and reports the deflection as the way from the stick centre.
inline Friction bristle_answer(const Vec2& force_n, const Vec2& deflection_m, Phase phase,
                               FrictionState& state) noexcept {
  Friction answer;
  answer.force_n = force_n;
  answer.phase = phase;
  if (phase == Phase::stick) {
    answer.from_centre_m = deflection_m;
    answer.centre_moved = true;  // the bristle is the law's own: the centre follows from it
  } else {
    state.slip_force_scale = 1;
  }
  state.phase = phase;
  state.deflection_m = within_huge(deflection_m);
  return answer;
}

}  // namespace fingerpad
