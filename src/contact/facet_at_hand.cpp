#include "contact/facet_at_hand.hpp"

#include <Eigen/Geometry>
#include <limits>

#include "contact/triangle_approach.hpp"

namespace fingerpad {

void FacetAtHand::turn_into_world() noexcept {
  is_ready_ = true;
  const PlacedSurface& surface = *surface_;
  const Part& part = *surface.part;
  const TriangleCorners facet = corners_of(part, triangle_);
  const Mat3& R = surface.R_WP;
  const Vec3 ab = facet.b - facet.a, bc = facet.c - facet.b, ca = facet.a - facet.c;
  corner_W_ = R * (part.centre_P + facet.a) + surface.p_WP;
  normal_W_ = R * facet.normal;
  inwards_W_ = {R * facet.normal.cross(ab), R * facet.normal.cross(ca), R * facet.normal.cross(bc)};
  opposite_m2_ = facet.normal.cross(bc).dot(ab);
  // One that is no more than its edges has no foot.
  if (!has_face(facet)) opposite_m2_ = std::numeric_limits<double>::infinity();
}

}  // namespace fingerpad
