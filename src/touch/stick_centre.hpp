#pragma once

#include "contact/facets_at_hand.hpp"

namespace fingerpad {

/// The stick centre that a trace and a picture show: the part's point that the skin holds on to. It stays
/// where it is while the pad sticks. No law reads it.
class StickCentre {
 public:
  void forget() noexcept { is_set_ = false; }
  bool is_set() const noexcept { return is_set_; }
  const Vec3& point_W() const noexcept { return point_W_; }

  /// That a search for its place may take before a servo's deadline: a trace shows it, no force depends on
  /// it.
  static constexpr long servo_looks = 2000;

  /// How its place is looked for.
  struct Search {
    long most_looks = servo_looks;  ///< then it is broken off
    const ClosestMemory* memory =
        nullptr;  ///< what the contact's own search keeps (ContactMethod::memory_of)
  };

  /// Where stick begins: S less the stretch, put on the surface; the tangent plane's point where that is far.
  /// @param stretch_W  in the tangent plane at S [m]
  /// @param normals    as the contact's own
  /// @param contact_triangle  index into Part::triangles of where S lies: the search starts there; -1:
  /// unknown
  /// @param facets    where they are kept from stick to stick: those near S
  void place(const PlacedSurface& surface, const Vec3& contact_W, const Vec3& stretch_W, Normals normals,
             int contact_triangle, FacetsAtHand& facets, const Search& search) noexcept;
  void place(const PlacedSurface& surface, const Vec3& contact_W, const Vec3& stretch_W, Normals normals,
             int contact_triangle = -1) noexcept {
    FacetsAtHand facets;
    place(surface, contact_W, stretch_W, normals, contact_triangle, facets, Search{});
  }
  /// A centre that a law drags along in the tangent plane.
  void drag(const Vec3& point_W) noexcept {
    is_set_ = true;
    point_W_ = point_W;
  }

 private:
  bool is_set_ = false;
  Vec3 point_W_ = Vec3::Zero();
};

}  // namespace fingerpad
