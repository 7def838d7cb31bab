#include "device/press_step.hpp"

#include <algorithm>
#include <cmath>

namespace fingerpad {

double deeper_m(const TickRecord& touched, double wanted_n, const SurfaceProperties& surface,
                double motion_left, double tolerated, double dt_s) noexcept {
  // Of what the normal force lacks or has too much, so much is made good in a tick, and so much at rest.
  constexpr double at_once = 0.3, at_rest_s = 0.1;
  const double at_rest = std::min(at_once, dt_s / at_rest_s);
  const double correction = at_rest + motion_left * (at_once - at_rest);
  const double stiffness_n_per_m = surface.stiffness_n_per_m + surface.damping_n_s_per_m / dt_s;
  const double most_m = press_step_share * wanted_n / stiffness_n_per_m;
  if (!(touched.normal_force_n > 0)) return most_m;
  const double lacks = wanted_n / touched.normal_force_n - 1;
  if (touched.normal_force_n > press_too_hard * wanted_n) return touched.depth_m * lacks;
  if (std::abs(lacks) < tolerated) return 0;
  // A damper answers to the step itself: the stiffer it is, the smaller the correction.
  return std::min(touched.depth_m * lacks * correction * surface.stiffness_n_per_m / stiffness_n_per_m,
                  most_m);
}

}  // namespace fingerpad
