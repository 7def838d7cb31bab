#include "base/tangent_frame.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace fingerpad {
namespace {

/// A unit vector across `normal` that depends on it alone: the world axis least aligned with it, projected.
Vec3 any_tangent(const Vec3& normal) noexcept {
  Eigen::Index axis = 0;
  normal.cwiseAbs().minCoeff(&axis);
  const Vec3 e = Vec3::Unit(axis);
  return (e - normal * normal.dot(e)).normalized();
}

/// asin(s)/s for 0 < s <= 1.
double half_angle_over_sine(double s) noexcept {
  // Below 0.02 the next term of the series is under 1e-15; contact moves by less than that from tick to tick.
  if (s < 0.02) return 1 + s * s * (1.0 / 6 + s * s * (3.0 / 40 + s * s * 15.0 / 336));
  return std::asin(std::min(1.0, s)) / s;
}

}  // namespace

Mat3 tangent_frame(const Vec3& normal, const Vec3& along) noexcept {
  Vec3 y = along - normal * normal.dot(along);
  const double length = y.norm();
  // Below this the projection's direction is rounding noise of `along` itself.
  const bool vanishes = !(length > 1e-9 * along.norm());
  y = vanishes ? any_tangent(normal) : Vec3(y / length);
  Mat3 frame;
  frame << y.cross(normal), y, normal;
  return frame;
}

Mat3 smallest_rotation(const Vec3& from, const Vec3& to) noexcept {
  const Vec3 axis = from.cross(to);
  const double cosine = from.dot(to);
  if (cosine < -1 + 1e-12) return Eigen::AngleAxisd(std::numbers::pi, any_tangent(from)).toRotationMatrix();
  Mat3 cross;
  cross << 0, -axis.z(), axis.y(), axis.z(), 0, -axis.x(), -axis.y(), axis.x(), 0;
  return Mat3::Identity() + cross +
         cross * cross / (1 + cosine);  // Rodrigues, with (1 - cos)/sin^2 = 1/(1 + cos)
}

Mat3 transported(const Mat3& frame, const Vec3& normal) noexcept {
  if (frame.col(2) == normal) return frame;
  Vec3 y;
  if (frame.col(2).dot(normal) < -1 + 1e-12) {
    y = -frame.col(1);
  } else {
    y = smallest_rotation(frame.col(2), normal) * frame.col(1);
  }
  return tangent_frame(normal, y);  // orthonormal again: rounding does not build up over a long contact
}

Vec3 surface_displacement(const Vec3& c, const Vec3& normal_c, const Vec3& s, const Vec3& normal_s) noexcept {
  const Vec3 chord = s - c;
  const double sin_half = 0.5 * (normal_s - normal_c).norm();  // of phi/2, exact to rounding however small
  if (sin_half < 1e-9) return chord - normal_s * normal_s.dot(chord);  // stretch and turn are below rounding
  const double cos_half = 0.5 * (normal_s + normal_c).norm();
  const Vec3 axis = cos_half > 1e-9 ? Vec3(normal_c.cross(normal_s) / (2 * sin_half * cos_half))
                                    : Vec3(tangent_frame(normal_s, chord).col(0));
  const Vec3 along = axis * axis.dot(chord);
  const Vec3 across = (chord - along) * half_angle_over_sine(sin_half);
  const Vec3 displacement = along + cos_half * across + sin_half * axis.cross(across);
  return displacement - normal_s * normal_s.dot(displacement);
}

}  // namespace fingerpad
