#pragma once

#include "motion/hand_settings.hpp"

namespace fingerpad {

/// A finger held by a device against a sampled wall: mass and damper, a spring and a backward-difference
/// damper computed once a tick and held over it (SCIENCE 4).
struct HeldWall {
  double mass_kg = 0.072;
  double damping_n_s_per_m = 0.5;     ///< b, of hand and device against the world
  double hand_stiffness_n_per_m = 0;  ///< of the spring by which a hand holds the finger where it means to
  double wall_damping_n_s_per_m = 0;  ///< B, of the wall
  double tick_s = 1e-3;               ///< T
  int delay_ticks = 0;                ///< d, from a force's computation to its display
  double encoder_m = 0;               ///< Delta, position quantum
  double coulomb_n = 0;               ///< f_c, dry friction of the device
};

/// The wall that a hand touches, of no damping yet, without its quantum and dry friction.
inline HeldWall wall_under(const HandSettings& hand, double rate_hz) {
  return {.mass_kg = hand.mass_kg,
          .damping_n_s_per_m = hand.damping_n_s_per_m,
          .hand_stiffness_n_per_m = hand.stiffness_n_per_m,
          .tick_s = 1 / rate_hz,
          .delay_ticks = hand.delay_ticks};
}

/// Largest stiffness [N/m] at which the loop is stable: the roots of the exactly discretised linear loop,
/// without quantum and dry friction. Zero where even the softest wall is unstable. Its time grows with the
/// delay's square: a hundredth of a second for 1,000 ticks.
double stable_stiffness(const HeldWall& wall);

/// Colgate & Schenkel 1997, passivity of the wall: b > K T/2 + |B|, so K < 2 (b - |B|)/T. For a loop without
/// delay; nan with one.
double colgate_schenkel_stiffness(const HeldWall& wall);

/// Abbott & Okamura 2005: K <= min(2 b/T, 2 f_c/Delta) for a quantum Delta and dry friction f_c. For a loop
/// without delay and wall damping; nan with either.
double abbott_okamura_stiffness(const HeldWall& wall);

/// The rule of thumb (b + B)/((d + 1/2) T).
double thumb_stiffness(const HeldWall& wall);

}  // namespace fingerpad
