#include "touch/finger_turn.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace fingerpad {
namespace {

/// axis sin(angle/2) and cos(angle/2) as a rotation vector, the short way round.
Vec3 rotation_vector(const Vec3& vector, double cosine) noexcept {
  const double sine = vector.norm();
  if (!(sine > 0) || !std::isfinite(sine)) return Vec3::Zero();
  const double angle = 2 * std::atan2(sine, std::abs(cosine));
  return vector * ((cosine < 0 ? -angle : angle) / sine);
}

}  // namespace

Vec3 finger_turn(const FingerSample& from, const FingerSample& to) noexcept {
  if (from.attitude && to.attitude) {
    const auto turn = *to.attitude * from.attitude->conjugate();
    return rotation_vector(turn.vec(), turn.w());
  }
  if (from.direction_W == to.direction_W) return Vec3::Zero();
  const double lengths = from.direction_W.norm() * to.direction_W.norm();
  if (!(lengths > 0) || !std::isfinite(lengths)) return Vec3::Zero();
  // cross = axis sin(angle), dot = cos(angle).
  const Vec3 cross = from.direction_W.cross(to.direction_W) / lengths;
  const double sine = cross.norm();
  if (!(sine > 0)) return Vec3::Zero();
  return cross * (std::atan2(sine, from.direction_W.dot(to.direction_W) / lengths) / sine);
}

}  // namespace fingerpad
