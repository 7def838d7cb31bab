#include "contact/facets_at_hand.hpp"

#include <cmath>
#include <utility>

#include "contact/facet_rule.hpp"
#include "contact/surface_point.hpp"
#include "part/part.hpp"

namespace fingerpad {
namespace {

/// Whether the second facet is the first's neighbour, or lies in its plane.
bool is_beside(const Part& part, int t, int other) noexcept {
  if ((part.neighbours.col(t).array() == other).any()) return true;
  const Vec3 normal = part.facet_normals.col(t);
  if ((normal - part.facet_normals.col(other)).squaredNorm() > same_normal2) return false;
  const Vec3 between = part.vertices.col(part.triangles(0, other)) - part.vertices.col(part.triangles(0, t));
  return std::abs(normal.dot(between)) <= direction_resolution * part.size_m();
}

}  // namespace

void FacetsAtHand::go_on_to(const PlacedSurface& surface, int t) noexcept {
  // The skin is held behind the contact: mostly on the facet that this has just left.
  std::swap(own_, beside_);
  own_.take(surface, t);
  goes_on_ = beside_.surface() == &surface && is_beside(*surface.part, t, beside_.triangle());
}

bool FacetsAtHand::look_up(const Vec3& p_W, Vec3& foot_W) noexcept {
  const PlacedSurface& surface = *own_.surface();
  const Vec3 p_P = surface.R_WP.transpose() * (p_W - surface.p_WP);
  const FacetFoot foot = foot_on_facet(*surface.part, own_.triangle(), p_P);
  if (foot.triangle < 0) return false;
  beside_.take(surface, foot.triangle);
  goes_on_ = true;
  foot_W = surface.R_WP * foot.point_P + surface.p_WP;
  return true;
}

}  // namespace fingerpad
