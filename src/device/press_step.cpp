#include "device/press_step.hpp"

#include <algorithm>

namespace fingerpad {

double deeper_m(const TickRecord& touched, double wanted_n, const SurfaceProperties& surface,
                double dt_s) noexcept {
  // Of what the normal force lacks or has too much, so much is made good in a tick.
  constexpr double correction = 0.3;
  const double stiffness_n_per_m = surface.stiffness_n_per_m + surface.damping_n_s_per_m / dt_s;
  const double most_m = press_step_share * wanted_n / stiffness_n_per_m;
  if (!(touched.normal_force_n > 0)) return most_m;
  const double lacks = wanted_n / touched.normal_force_n - 1;
  if (touched.normal_force_n > press_too_hard * wanted_n) return touched.depth_m * lacks;
  // A damper answers to the step itself: the stiffer it is, the smaller the correction.
  return std::min(touched.depth_m * lacks * correction * surface.stiffness_n_per_m / stiffness_n_per_m,
                  most_m);
}

}  // namespace fingerpad
