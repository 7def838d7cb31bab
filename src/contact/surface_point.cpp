#include "contact/surface_point.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "contact/closest_memory.hpp"
#include "contact/facet_rule.hpp"
#include "contact/facet_view.hpp"
#include "contact/triangle_tree.hpp"

namespace fingerpad {
namespace {

bool outside_padded_box(const Part& part, const Vec3& q, double reach_m) noexcept {
  const double beyond_m = (q.cwiseAbs() - part.half_extent).maxCoeff();
  const double rounding_m = 1e-12 * (part.size_m() + part.centre_P.norm());
  return !(beyond_m <= reach_m + rounding_m);
}

/// @param hint  a seed, or a memory
template <class Hint>
SurfacePoint nearest(const TriangleTree& tree, const Vec3& p_P, Normals normals, Hint& hint,
                     double reach_m) noexcept {
  const Part& part = tree.part();
  const Vec3 q = p_P - part.centre_P;
  if (outside_padded_box(part, q, reach_m + normals->strays * part.size_m())) return {};
  // No bound on the search: what lies deep inside is answered whatever the reach.
  const ClosestTriangle found = tree.closest(q, hint, std::numeric_limits<double>::infinity());
  return surface_point_at(tree, found, p_P, normals, reach_m);
}

/// Whether two facets lie in one plane, to rounding of their normals.
bool are_level(const Part& part, int t, int next) noexcept {
  constexpr double least_sine2 = 1e-16;
  const Vec3 here = part.facet_normals.col(t), there = part.facet_normals.col(next);
  return here.dot(there) > 0 && here.cross(there).squaredNorm() <= least_sine2;
}

/// So far from the first facet's a normal may be turned on a way over smooth edges: 20 degrees. What lies
/// beyond such a way is no other sheet, as it would be round a rib.
constexpr double hardly_turned_cos = 0.94;

/// The facet under q some edges away from triangle t, of which at most one is bent, or two where none is a
/// crease, or any number where besides the surface hardly turns on the way; -1: not found.
/// @param view  of triangle t
int find_foot_around(const Part& part, int t, FacetView view, Vec3& foot) noexcept {
  constexpr int most_edges = 8;
  const Vec3 normal = part.facet_normals.col(t);
  int bent = 0, most_bent = 2;
  bool hardly_turns = true;
  for (int k = 0; k < most_edges; ++k) {
    const int edge = view.edge_farthest_behind(), next = part.neighbours(edge, t);
    if (next < 0) return -1;
    if (has_crease(part, t, edge)) most_bent = 1;
    bent += are_level(part, t, next) ? 0 : 1;
    hardly_turns = hardly_turns && normal.dot(part.facet_normals.col(next)) > hardly_turned_cos;
    if (bent > most_bent && !(hardly_turns && most_bent > 1)) return -1;
    t = next;
    view = FacetView(part, next, view.q);
    if (view.find_foot(foot)) return t;
  }
  return -1;
}

}  // namespace

SurfacePoint surface_point_at(const TriangleTree& tree, const ClosestTriangle& found, const Vec3& p_P,
                              Normals normals, double reach_m) noexcept {
  const Part& part = tree.part();
  SurfacePoint result;
  const Vec3 q = p_P - part.centre_P;
  if (found.triangle < 0) return result;
  const int t = found.triangle;
  const Vec3 offset = q - found.at.point;
  const double distance_m =
      std::isfinite(found.at.distance2_m2) ? std::sqrt(found.at.distance2_m2) : offset.stableNorm();
  if (!std::isfinite(distance_m)) return result;  // no double can tell how far
  const Vec3 pseudo = pseudonormal(part, t, found.at.feature);
  const bool inside = offset.dot(pseudo) < 0;
  if (normals->own_surface != nullptr) {
    const SurfacePoint own = normals->own_surface(tree, found, q, inside ? -distance_m : distance_m);
    return own.signed_distance_m <= reach_m ? own : result;
  }
  if (!inside && !(distance_m <= reach_m)) return result;

  result.triangle = t;
  result.point_P = part.centre_P + found.at.point;
  result.pseudonormal_P = pseudo;
  result.signed_distance_m = inside ? -distance_m : distance_m;
  const Vec3 outward = inside ? Vec3(-offset) : offset;
  result.normal_P = facet_normal(part, t, found.at.feature, pseudo, outward, distance_m);
  result.normal_P = shaded_normal(tree, t, found.at, normals, result.normal_P);
  return result;
}

Vec3 shaded_normal(const TriangleTree& tree, int t, const TrianglePoint& at, Normals normals,
                   const Vec3& facet_normal_P) noexcept {
  if (normals->shows_facets() || !is_smooth(tree.part(), t, at.feature)) return facet_normal_P;
  return normals->shade(tree, t, at, facet_normal_P);
}

FacetFoot foot_on_facet(const Part& part, int t, const Vec3& p_P) noexcept {
  return foot_on_facet(part, t, FacetView(part, t, p_P - part.centre_P));
}

FacetFoot foot_on_facet(const Part& part, int t, const FacetView& view) noexcept {
  Vec3 foot;
  if (view.find_foot(foot)) return {part.centre_P + foot, t};
  const int around = find_foot_around(part, t, view, foot);
  if (around >= 0) return {part.centre_P + foot, around};
  const Feature feature = view.nearest_feature();
  const int across = is_edge(feature) ? part.neighbours(edge_of(feature), t) : -1;
  if (across >= 0 && FacetView(part, across, view.q).find_foot(foot)) return {part.centre_P + foot, across};
  return {};
}

SurfacePoint nearest_surface_point(const TriangleTree& tree, const Vec3& p_P, Normals normals, int seed,
                                   double reach_m) noexcept {
  return nearest(tree, p_P, normals, seed, reach_m);
}

SurfacePoint nearest_surface_point(const TriangleTree& tree, const Vec3& p_P, Normals normals,
                                   ClosestMemory& memory, double reach_m) noexcept {
  return nearest(tree, p_P, normals, memory, reach_m);
}

SurfacePoint nearest_surface_point(const TriangleTree& tree, const Vec3& p_P, Normals normals,
                                   BriefSearch& search, double reach_m) noexcept {
  return nearest(tree, p_P, normals, search, reach_m);
}

SurfacePoint nearest_plane_point(const Vec3& point_P, const Vec3& normal_P, const Vec3& p_P) noexcept {
  SurfacePoint result;
  result.signed_distance_m = (p_P - point_P).dot(normal_P);
  result.point_P = p_P - result.signed_distance_m * normal_P;
  result.normal_P = normal_P;
  result.pseudonormal_P = normal_P;
  return result;
}

}  // namespace fingerpad
