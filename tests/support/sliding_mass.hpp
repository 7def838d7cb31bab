#pragma once

#include "support/plane_contact.hpp"

namespace fingerpad::test {

/// A mass on a plane under a law, a push and a viscous damper. The friction of a tick is held over it, as a
/// servo loop does; in between the motion is integrated in fine substeps.
struct SlidingMass {
  PlaneContact contact;
  double mass_kg = 1;
  double damping_n_s_per_m = 0;
  int substeps = 8;
  double x_m = 0, v_m_per_s = 0, t_s = 0;
  Friction friction{};

  /// One tick: the law answers where the mass stands, then the mass moves. `push(x, t)` in newtons along x.
  template <typename Push>
  void tick(Push push) {
    contact.motion.applied_force_n = {push(x_m, t_s), 0};
    friction = contact.move_to({x_m, 0}, {v_m_per_s, 0});
    const double h = contact.motion.dt_s / substeps;
    for (int i = 0; i < substeps; ++i) {
      const double force = push(x_m, t_s) + friction.force_n.x() - damping_n_s_per_m * v_m_per_s;
      v_m_per_s += h * force / mass_kg;
      x_m += h * v_m_per_s;
      t_s += h;
    }
  }
};

}  // namespace fingerpad::test
