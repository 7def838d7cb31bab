#pragma once

#include "contact/placed_surface.hpp"

namespace fingerpad {

/// The stick centre: a point of the part, so that it neither drifts nor slides when the contact frame turns.
///
/// The law says how far S is from the centre (a 2-vector in frame C); the centre is then sought on the
/// surface, so that the displacement measured back along the surface is that vector. What a surface does not
/// allow (the centre would lie beyond an edge) is carried as a remainder in frame C, so that no force jumps.
class StickCentre {
 public:
  void forget() noexcept { is_set_ = false; }
  bool is_set() const noexcept { return is_set_; }
  const Vec3& point_W() const noexcept { return point_W_; }

  /// Places the centre so that S is displaced from it by `from_centre_m`.
  /// @param frame_WC   contact frame at S, Cz the normal
  /// @param normals    as the contact's own
  /// @param on_surface false: a point of the tangent plane is good enough (a centre dragged along in slip)
  /// @param contact_triangle  index into Part::triangles of where S lies: the search starts there; -1:
  /// unknown
  void place(const PlacedSurface& surface, const Vec3& contact_W, const Mat3& frame_WC,
             const Vec2& from_centre_m, Normals normals, bool on_surface, int contact_triangle = -1) noexcept;

  /// Displacement of S from the centre, in frame C [m]; zero without a centre.
  Vec2 displacement(const Vec3& contact_W, const Mat3& frame_WC) const noexcept;

 private:
  bool is_set_ = false;
  Vec3 point_W_ = Vec3::Zero();
  Vec3 normal_W_ = Vec3::UnitZ();
  Vec2 remainder_m_ = Vec2::Zero();
};

}  // namespace fingerpad
