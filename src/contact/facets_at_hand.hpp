#pragma once

#include "contact/closest_memory.hpp"
#include "contact/facet_at_hand.hpp"

namespace fingerpad {

struct FacetView;

/// Finds tick after tick what foot_on_facet finds, near a contact that moves on from facet to facet: the
/// contact's own facet and the one beside it where a foot lay last are at hand: for speed alone. Beside them
/// is kept what searches around go by, whose answer it may make better where they are bounded (BriefSearch).
class FacetsAtHand {
 public:
  /// The foot of p_W on the contact's facet, or on one that goes on from it.
  /// @param t       the contact's facet, index into Part::triangles
  /// @param foot_W  written where there is one
  /// @pre the surface is a part, and stays where it is. noexcept, allocates nothing.
  bool find_foot(const PlacedSurface& surface, int t, const Vec3& p_W, Vec3& foot_W) noexcept {
    if (!own_.is(surface, t)) go_on_to(surface, t);
    if (own_.is_ready() &&
        (own_.find_foot(p_W, foot_W) || (goes_on_ && beside_.is_ready() && beside_.find_foot(p_W, foot_W))))
      return true;
    return find_beside(p_W, foot_W);
  }
  /// For searches where they find none.
  ClosestMemory& around() noexcept { return around_; }

 private:
  void go_on_to(const PlacedSurface& surface, int t) noexcept;
  bool find_beside(const Vec3& p_W, Vec3& foot_W) noexcept;

  static bool has_foot(FacetAtHand& facet, const FacetView& view, double slip_m, const Vec3& p_W,
                       Vec3& foot_W) noexcept;

  FacetAtHand own_, beside_;
  ClosestMemory around_;
  bool goes_on_ = false;  ///< beside_ goes on from own_: across an edge, or in one plane
};

}  // namespace fingerpad
