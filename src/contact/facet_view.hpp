#pragma once

#include <algorithm>
#include <array>

#include "contact/triangle_approach.hpp"

namespace fingerpad {

/// A facet seen from a point, reckoned once for all that is asked of it.
struct FacetView {
  TriangleCorners facet;
  Vec3 q;
  FaceShares shares;

  FacetView(const Part& part, int t, const Vec3& from) noexcept
      : facet(corners_of(part, t)), q(from), shares(facet, from) {}

  /// Whether the closest point of the facet, as approach_triangle finds it, is on its face.
  /// @param foot  that point, written where it is
  bool find_foot(Vec3& foot) const noexcept {
    if (!shares.are_of_face()) return false;
    foot = q - facet.normal.dot(q - facet.a) * facet.normal;
    return true;
  }
  /// The feature that approach_triangle finds the closest point on.
  Feature nearest_feature() const noexcept { return fingerpad::nearest_feature(facet, shares, q); }
  /// The edge, as Part::neighbours counts them, beyond which a place beside the facet lies: of two that
  /// with the larger triangle between.
  int edge_farthest_behind() const noexcept {
    const std::array<double, 3> of_edge{shares.c, shares.a, shares.b};
    return static_cast<int>(std::min_element(of_edge.begin(), of_edge.end()) - of_edge.begin());
  }
  /// Whether the point is beside the face by more than `off_m` [m], whatever that loses in rounding.
  bool is_surely_beside(double off_m) const noexcept {
    const double least = std::min({shares.a, shares.b, shares.c});
    return least < 0 && least * least > off_m * off_m * shares.sides2_m2;
  }
};

}  // namespace fingerpad
