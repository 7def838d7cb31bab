#include "motion/scripted_motion.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace fingerpad {

Vec3 ScriptedMotion::at(double t_s) const noexcept {
  const double turn = 2 * std::numbers::pi * frequency_hz * t_s;
  switch (kind) {
    case Kind::line:
      return duration_s > 0 ? Vec3(from_m + (to_m - from_m) * (t_s / duration_s)) : from_m;
    case Kind::sine:
      return centre_m + direction * (amplitude_m * std::sin(turn));
    case Kind::circle:
      return centre_m + amplitude_m * (std::cos(turn) * direction + std::sin(turn) * normal.cross(direction));
  }
  return centre_m;
}

}  // namespace fingerpad
