#include "base/tangent_frame.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/unit_vector.hpp"

namespace fingerpad {
namespace {

/// A unit vector across `normal` that depends on it alone: the world axis least aligned with it, projected.
Vec3 any_tangent(const Vec3& normal) noexcept {
  Eigen::Index axis = 0;
  normal.cwiseAbs().minCoeff(&axis);
  const Vec3 e = Vec3::Unit(axis);
  return (e - normal * normal.dot(e)).normalized();
}

/// @param y  unit, across `normal`
Mat3 frame_of(const Vec3& y, const Vec3& normal) noexcept {
  Mat3 frame;
  frame.col(0) = y.cross(normal);
  frame.col(1) = y;
  frame.col(2) = normal;
  return frame;
}

/// surface_displacement for s2 = sin^2(phi/2) < 1e-4, as from tick to tick: every factor by its series in s2,
/// whose next term is below rounding.
Vec3 slightly_turned(const Vec3& chord, const Vec3& normal_c, const Vec3& normal_s, double s2) noexcept {
  const double stretch = 1 + s2 * (1.0 / 6 + s2 * (3.0 / 40 + s2 * (5.0 / 112)));
  const double shrink = 1.0 / 3 + s2 * (2.0 / 15 + s2 * (8.0 / 105));  // (1 - stretch cos(phi/2))/s2
  const double half_secant = 0.5 + s2 * (1.0 / 4 + s2 * (3.0 / 16 + s2 * (5.0 / 32)));
  const Vec3 turn = half_secant * normal_c.cross(normal_s);  // sin(phi/2) times the axis
  const Vec3 displacement =
      (1 - s2 * shrink) * chord + shrink * turn.dot(chord) * turn + stretch * turn.cross(chord);
  return displacement - normal_s * normal_s.dot(displacement);
}

}  // namespace

Mat3 tangent_frame(const Vec3& normal, const Vec3& along) noexcept {
  Vec3 y = along - normal * normal.dot(along);
  const double length = y.norm();
  // Below this the projection's direction is rounding noise of `along` itself.
  const bool vanishes = !(length > 1e-9 * along.norm());
  return frame_of(vanishes ? any_tangent(normal) : Vec3(y / length), normal);
}

Mat3 transported(const Mat3& frame, const Vec3& normal) noexcept {
  if (differ_by_rounding_only(frame.col(2), normal)) return frame;
  const Vec3 from = frame.col(2), y = frame.col(1);
  const double cosine = from.dot(normal);
  if (cosine < -1 + 1e-12) return tangent_frame(normal, -y);
  // The smallest rotation of a vector across `from`.
  const Vec3 turned = y - (from + normal) * (normal.dot(y) / (1 + cosine));
  // Orthonormal again: rounding does not build up over a long contact. What is so near to 1 in length as a
  // turned axis is made unit by one of Newton's steps, without a root or a division.
  const Vec3 across = turned - normal * normal.dot(turned);
  const double beyond = across.squaredNorm() - 1;
  return frame_of(std::abs(beyond) < 1e-8 ? Vec3((1 - 0.5 * beyond) * across) : across.normalized(), normal);
}

Vec3 surface_displacement(const Vec3& c, const Vec3& normal_c, const Vec3& s, const Vec3& normal_s) noexcept {
  const Vec3 chord = s - c;
  const double s2 = 0.25 * (normal_s - normal_c).squaredNorm();  // sin^2(phi/2), exact however small
  if (s2 < 1e-4) return slightly_turned(chord, normal_c, normal_s, s2);
  const double sin_half = std::sqrt(s2);
  const double cos_half = 0.5 * (normal_s + normal_c).norm();
  const Vec3 axis = cos_half > 1e-9 ? Vec3(normal_c.cross(normal_s) / (2 * sin_half * cos_half))
                                    : Vec3(tangent_frame(normal_s, chord).col(0));
  const Vec3 along = axis * axis.dot(chord);
  const Vec3 across = (chord - along) * (std::asin(std::min(1.0, sin_half)) / sin_half);
  const Vec3 displacement = along + cos_half * across + sin_half * axis.cross(across);
  return displacement - normal_s * normal_s.dot(displacement);
}

}  // namespace fingerpad
