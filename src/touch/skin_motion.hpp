#pragma once

#include "fingerpad/surface_properties.hpp"
#include "friction/law.hpp"
#include "touch/wall.hpp"

namespace fingerpad {

/// How the finger's skin has moved over a tick, whatever it touches, in W: as the finger did, and by its
/// turning.
struct SkinMotion {
  double dt_s = 1e-3;
  Vec3 displacement_W = Vec3::Zero();  ///< of Q since the last tick [m]
  Vec3 velocity_W = Vec3::Zero();      ///< of Q
  Vec3 turn_W = Vec3::Zero();          ///< rotation vector since the last tick [rad]; zero without radius
  bool turns = false;                  ///< whether that is anything
};

/// How the finger stands in a tick, as friction reads it.
struct FingerStand {
  Vec3 p_WQ;         ///< Q [m]
  Vec3 direction_W;  ///< unit
  Vec3 push_W_n;     ///< what pushes it [N], finite
};

/// What a wall's friction law is told: the skin's motion in the wall's frame, and how the finger lies on it.
/// The step is P_n of the finger's displacement and of what the skin rolls by, turn x (S - Q); never the way
/// of the contact point S (DESIGN, "Friction in one place"). Zero where the wall has only now been touched.
/// @param frame_WC  of the wall: Cx, Cy, and Cz its normal
/// @param inclination_rad  of its direction to the wall
TangentialMotion tangential_motion(const SkinMotion& skin, const FingerStand& finger, const Wall& wall,
                                   const SurfaceProperties& surface, const Mat3& frame_WC,
                                   double inclination_rad, bool is_touched_anew) noexcept;

/// How steeply a finger stands on a surface, 0 .. pi/2; both of unit length.
double inclination_rad(const Vec3& direction_W, const Vec3& normal_W) noexcept;

/// The same, tick by tick: of a finger that lies on a facet as it lay before, it is not reckoned again.
class LastInclination {
 public:
  double of(const Vec3& direction_W, const Vec3& normal_W) noexcept {
    if (direction_W.dot(normal_W) == cosine_) return inclination_rad_;
    cosine_ = direction_W.dot(normal_W);
    return inclination_rad_ = inclination_rad(direction_W, normal_W);
  }

 private:
  double cosine_ = 2;  ///< that no two directions have
  double inclination_rad_ = 0;
};

}  // namespace fingerpad
