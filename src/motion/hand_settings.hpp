#pragma once

namespace fingerpad {

/// A simulated hand and device; keys of [hand].
struct HandSettings {
  double mass_kg = 0.07;
  double damping_n_s_per_m = 0.5;          ///< against the world
  double stiffness_n_per_m = 200;          ///< the hand's spring towards the motion
  double encoder_m = 3e-5;                 ///< position quantum; 0: exact
  int delay_ticks = 0;                     ///< ticks from a force's computation to its display
  double coulomb_n = 0;                    ///< dry friction of the device, along each axis by itself
  bool free_axis[3] = {true, true, true};  ///< world axes the hand moves along by itself
};

}  // namespace fingerpad
