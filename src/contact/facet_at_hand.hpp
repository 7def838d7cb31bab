#pragma once

#include <array>

#include "contact/placed_surface.hpp"

namespace fingerpad {

/// A facet that feet are looked for on tick after tick: what that takes of it, in the world. Speed alone: it
/// finds what foot_on_facet finds on the facet itself, to rounding.
class FacetAtHand {
 public:
  /// Takes a facet, where it is not the one that is at hand.
  /// @param t  index into Part::triangles
  /// @pre the surface stays where it is
  void take(const PlacedSurface& surface, int t) noexcept {
    name(surface, t);
    make_ready();
  }
  /// The same, but for what feet take of it: nobody may look for one before that is made ready.
  void name(const PlacedSurface& surface, int t) noexcept {
    if (is(surface, t)) return;
    surface_ = &surface;
    triangle_ = t;
    is_ready_ = false;
  }
  bool is_ready() const noexcept { return is_ready_; }
  void make_ready() noexcept {
    if (!is_ready_) turn_into_world();
  }
  bool is(const PlacedSurface& surface, int t) const noexcept {
    return triangle_ == t && surface_ == &surface;
  }
  const PlacedSurface* surface() const noexcept { return surface_; }  ///< null: none is at hand
  int triangle() const noexcept { return triangle_; }
  /// @param foot_W  the point of the facet under p_W, written where there is one
  /// @pre is_ready()
  bool find_foot(const Vec3& p_W, Vec3& foot_W) const noexcept {
    const Vec3 from_corner = p_W - corner_W_;
    if (!(inwards_W_[0].dot(from_corner) > 0 && inwards_W_[1].dot(from_corner) > 0 &&
          inwards_W_[2].dot(from_corner) > opposite_m2_))
      return false;
    foot_W = p_W - normal_W_.dot(from_corner) * normal_W_;
    return true;
  }

 private:
  void turn_into_world() noexcept;

  const PlacedSurface* surface_ = nullptr;
  int triangle_ = -1;
  bool is_ready_ = true;  ///< also where none is at hand, which has no foot
  Vec3 corner_W_ = Vec3::Zero(), normal_W_ = Vec3::UnitZ();
  /// Across each edge, as long as it; the first two meet in the corner.
  std::array<Vec3, 3> inwards_W_{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  double opposite_m2_ = 0;  ///< where the third edge lies along its own
};

}  // namespace fingerpad
