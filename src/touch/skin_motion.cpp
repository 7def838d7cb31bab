#include "touch/skin_motion.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace fingerpad {

TangentialMotion tangential_motion(const SkinMotion& skin, const FingerStand& finger, const Wall& wall,
                                   const SurfaceProperties& surface, const Mat3& frame_WC,
                                   double inclination_rad, bool is_touched_anew) noexcept {
  const auto in_plane = [&frame_WC](const Vec3& v) {
    return Vec2(frame_WC.col(0).dot(v), frame_WC.col(1).dot(v));
  };
  TangentialMotion motion;
  motion.dt_s = skin.dt_s;
  motion.mu_static = surface.mu_static;
  motion.mu_dynamic = surface.mu_dynamic;
  motion.surface_stiffness_n_per_m = surface.stiffness_n_per_m;
  motion.velocity_m_per_s = in_plane(skin.velocity_W);
  if (!is_touched_anew) motion.step_m = in_plane(skin.displacement_W);
  if (skin.turns) {  // and rolls its skin over the part
    const Vec2 rolled_m = in_plane(skin.turn_W.cross(wall.point_W - finger.p_WQ));
    motion.velocity_m_per_s += rolled_m / skin.dt_s;
    if (!is_touched_anew) motion.step_m += rolled_m;
  }
  motion.inclination_rad = inclination_rad;
  motion.applied_force_n = in_plane(finger.push_W_n);
  const Vec2 longitudinal = in_plane(finger.direction_W);
  const double length = longitudinal.norm();
  // A finger straight along the normal names no axis in the plane: the transported frame serves.
  motion.longitudinal = length > 1e-9 ? Vec2(longitudinal / length) : Vec2(0, 1);
  return motion;
}

double inclination_rad(const Vec3& direction_W, const Vec3& normal_W) noexcept {
  return std::asin(std::min(1.0, std::abs(direction_W.dot(normal_W))));
}

}  // namespace fingerpad
