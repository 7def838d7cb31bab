#include "motion/placed_motion.hpp"

#include <Eigen/Geometry>

namespace fingerpad {

void place(Motion& motion, const Mat3& rotation, const Vec3& position_m) {
  motion.p_WQ = (rotation * motion.p_WQ).colwise() + position_m;
  for (Points* vectors : {&motion.direction_W, &motion.push_W_n, &motion.velocity_W}) {
    if (vectors->cols() > 0) *vectors = rotation * *vectors;
  }
  const Attitude turn(rotation);
  for (Attitude& attitude : motion.attitude) attitude = (turn * attitude).normalized();
}

void place(ScriptedMotion& motion, const Mat3& rotation, const Vec3& position_m) {
  for (Vec3* point : {&motion.from_m, &motion.to_m, &motion.centre_m})
    *point = rotation * *point + position_m;
  for (Vec3* direction : {&motion.direction, &motion.normal}) *direction = rotation * *direction;
}

}  // namespace fingerpad
