#include "touch/skin_motion.hpp"

#include <algorithm>
#include <cmath>

namespace fingerpad {

TangentialMotion tangential_motion(const SkinMotion& skin, const FingerSample& sample, const Wall& wall,
                                   const SurfaceProperties& surface, const Mat3& frame_WC,
                                   bool is_touched_anew) noexcept {
  const auto in_plane = [&frame_WC](const Vec3& v) {
    return Vec2(frame_WC.col(0).dot(v), frame_WC.col(1).dot(v));
  };
  TangentialMotion motion;
  motion.dt_s = skin.dt_s;
  motion.mu_static = surface.mu_static;
  motion.mu_dynamic = surface.mu_dynamic;
  motion.surface_stiffness_n_per_m = surface.stiffness_n_per_m;
  // A finger that turns rolls its skin over the part.
  const Vec3 rolled_m = skin.turn_W.cross(wall.point_W - sample.p_WQ);
  motion.velocity_m_per_s = in_plane(skin.velocity_W + rolled_m / skin.dt_s);
  if (!is_touched_anew) motion.step_m = in_plane(skin.displacement_W + rolled_m);
  motion.inclination_rad = std::asin(std::min(1.0, std::abs(sample.direction_W.dot(frame_WC.col(2)))));
  motion.applied_force_n = in_plane(sample.push_W_n);
  const Vec2 longitudinal = in_plane(sample.direction_W);
  const double length = longitudinal.norm();
  // A finger straight along the normal names no axis in the plane: the transported frame serves.
  motion.longitudinal = length > 1e-9 ? Vec2(longitudinal / length) : Vec2(0, 1);
  return motion;
}

}  // namespace fingerpad
