#pragma once

#include <cmath>

#include "friction/bounded.hpp"
#include "friction/plane_vector.hpp"

namespace fingerpad {

/// Dahl's equation dz = dx - |dx| z/z_c over one straight step, solved exactly, so that no step is too long.
/// @pre z_c_m > 0
inline Vec2 dahl_step(const Vec2& z_m, const Vec2& step_m, double z_c_m) noexcept {
  const double moved = length(step_m);
  if (moved == 0) return z_m;
  // z_s + (z - z_s) e^(-|dx|/z_c) with z_s = z_c dx/|dx|, written so that a tiny step loses no digits.
  return z_m - std::expm1(-moved / z_c_m) * (direction_of(step_m) * z_c_m - z_m);
}

/// Slip is where more of a step is plastic than elastic; at rest a bristle sticks.
inline Phase bristle_phase(const Vec2& stretch_m, const Vec2& step_m) noexcept {
  const double moved = length(step_m);
  return moved > 0 && length(stretch_m) < 0.5 * moved ? Phase::slip : Phase::stick;
}

/// Brings the state up to date and reports the deflection as the way from the stick centre.
inline Friction bristle_answer(const TangentialMotion& m, const Vec2& force_n, const Vec2& deflection_m,
                               Phase phase, FrictionState& state) noexcept {
  Friction answer;
  answer.force_n = force_n;
  answer.phase = phase;
  if (phase == Phase::stick) {
    answer.from_centre_m = deflection_m;
    answer.centre_moved = true;  // the bristle is the law's own: the centre follows from it
  } else {
    const double pull = length(force_n);
    if (pull > 0) state.slip_direction = direction_of(-force_n);
    state.slip_force_scale = 1;
  }
  state.phase = phase;
  state.deflection_m = within_huge(deflection_m);
  state.last_speed_m_per_s = length(m.velocity_m_per_s);
  return answer;
}

}  // namespace fingerpad
