#include "contact/facets_at_hand.hpp"

#include <cmath>
#include <utility>

#include "contact/facet_rule.hpp"
#include "contact/facet_view.hpp"
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
  own_.name(surface, t);
  goes_on_ = beside_.surface() == &surface && is_beside(*surface.part, t, beside_.triangle());
}

/// Whether a facet has the foot. It is made ready for that only where this is not told at once.
/// @param view    of the facet, from p_W
/// @param slip_m  more than rounding may move the point against the facet
bool FacetsAtHand::has_foot(FacetAtHand& facet, const FacetView& view, double slip_m, const Vec3& p_W,
                            Vec3& foot_W) noexcept {
  if (!facet.is_ready() && view.is_surely_beside(slip_m)) return false;
  facet.make_ready();
  return facet.find_foot(p_W, foot_W);
}

bool FacetsAtHand::find_beside(const Vec3& p_W, Vec3& foot_W) noexcept {
  const PlacedSurface& surface = *own_.surface();
  const Part& part = *surface.part;
  const Vec3 p_P = surface.R_WP.transpose() * (p_W - surface.p_WP), q = p_P - part.centre_P;
  const FacetView own(part, own_.triangle(), q);
  constexpr double far_above_rounding = 1e-11;
  const double slip_m =
      far_above_rounding *
      (part.half_extent + part.centre_P.cwiseAbs() + surface.p_WP.cwiseAbs() + p_W.cwiseAbs()).sum();
  if (!own_.is_ready() && has_foot(own_, own, slip_m, p_W, foot_W)) return true;
  if (goes_on_) {
    if (beside_.is_ready()) {
      if (beside_.find_foot(p_W, foot_W)) return true;
    } else if (has_foot(beside_, FacetView(part, beside_.triangle(), q), slip_m, p_W, foot_W)) {
      return true;
    }
  }
  const FacetFoot foot = foot_on_facet(part, own_.triangle(), own);
  if (foot.triangle < 0) return false;
  beside_.name(surface, foot.triangle);
  goes_on_ = true;
  foot_W = surface.R_WP * foot.point_P + surface.p_WP;
  return true;
}

}  // namespace fingerpad
