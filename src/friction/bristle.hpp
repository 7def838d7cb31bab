#pragma once

#include "friction/bounded.hpp"
#include "friction/exponential.hpp"
#include "friction/plane_vector.hpp"

namespace fingerpad {

/// Dahl's equation dz = dx - |dx| z/z_c over one straight step, solved exactly, so that no step is too long.
/// @param x  |step|/z_c, >= 0
inline PlaneVector dahl_step(const PlaneVector& z_m, const PlaneVector& step_m, double x) noexcept {
  if (!(x > 0)) return z_m + step_m;
  // z_s + (z - z_s) e^(-x) with z_s = z_c dx/|dx|, written so that a tiny step loses no digits.
  const Yielding yielded = yielding(x);
  return z_m + step_m * yielded.per_x - z_m * yielded.share;
}

/// Slip is where more of a step is plastic than elastic; at rest a bristle sticks.
inline Phase bristle_phase(const PlaneVector& stretch_m, double moved_m) noexcept {
  return 4 * stretch_m.square() < moved_m * moved_m ? Phase::slip : Phase::stick;
}

/// Brings the state up to date and reports the deflection as the way from the stick centre.
inline Friction bristle_answer(const PlaneVector& force_n, const PlaneVector& deflection_m, Phase phase,
                               FrictionState& state) noexcept {
  Friction answer;
  answer.force_n = force_n;
  answer.phase = phase;
  answer.ruptures = phase == Phase::slip && state.phase == Phase::stick ? 1 : 0;
  if (phase == Phase::stick) {
    answer.stretch_m = deflection_m;
    answer.centre_moved = true;  // the bristle is the law's own: the centre follows from it
  } else {
    state.slip_force_scale = 1;
  }
  state.phase = phase;
  state.stretch_m = deflection_m;
  return answer;
}

/// First touch: the bristle is not stretched, whatever the speed.
inline Friction bristle_at_rest(FrictionState& state) noexcept {
  state = FrictionState{};
  return bristle_answer({0, 0}, {0, 0}, Phase::stick, state);
}

}  // namespace fingerpad
