#include "contact/surface_point.hpp"

#include <cmath>

#include "contact/curved_closest.hpp"
#include "contact/proxy_sweep.hpp"

namespace fingerpad {
namespace {

/// Closer than this fraction of the part's size the direction to the finger is rounding, not geometry.
constexpr double direction_resolution = 1e-9;
/// Unit vectors this near are the same, up to the rounding that made them.
constexpr double same_normal2 = 1e-18;

int corner_of(Feature feature) noexcept {
  return static_cast<int>(feature) - static_cast<int>(Feature::vertex0);
}
int edge_of(Feature feature) noexcept {
  return static_cast<int>(feature) - static_cast<int>(Feature::edge0);
}
bool is_edge(Feature feature) noexcept {
  return feature >= Feature::edge0 && feature <= Feature::edge2;
}
Vec3 pseudonormal(const Part& part, int t, Feature feature) noexcept {
  if (feature == Feature::face) return part.facet_normals.col(t);
  if (is_edge(feature)) return part.edge_pseudonormals.col(3 * t + edge_of(feature));
  return part.vertex_pseudonormals.col(part.welded(corner_of(feature), t));
}

bool has_crease(const Part& part, int t, int edge) noexcept {
  return (part.creases[t] >> edge & 1) != 0;
}

/// Whether the triangles around a corner close a ring: not at the border of an open part. Fans of more than
/// 64 count as closed.
bool is_ringed(const Part& part, int t, int corner) noexcept {
  const int vertex = part.welded(corner, t);
  int edge = corner, at = t;
  for (int turn = 0; turn < 64; ++turn) {
    const int next = part.neighbours(edge, at);
    if (next < 0 || next == t) return next == t;
    int k = 0;
    while (k < 2 && part.welded(k, next) != vertex) ++k;
    // Of the two edges at the vertex, the one not come by.
    edge = part.neighbours(k, next) == at ? (k + 2) % 3 : k;
    at = next;
  }
  return true;
}

/// Whether the surface is smooth at a feature, so that interpolated normals may be used there.
bool is_smooth(const Part& part, int t, Feature feature) noexcept {
  if (feature == Feature::face) return true;
  if (is_edge(feature)) return !has_crease(part, t, edge_of(feature));
  const int corner = corner_of(feature);
  if (has_crease(part, t, corner) || has_crease(part, t, (corner + 2) % 3)) return false;
  const Vec3 all_round = part.vertex_pseudonormals.col(part.welded(corner, t));
  return (part.corner_normals.col(3 * t + corner) - all_round).squaredNorm() <= same_normal2 &&
         is_ringed(part, t, corner);
}

/// Whether both facets at an edge lie in one plane.
bool is_flat_edge(const Part& part, int t, int edge) noexcept {
  const int other = part.neighbours(edge, t);
  return other >= 0 &&
         (part.facet_normals.col(t) - part.facet_normals.col(other)).squaredNorm() <= same_normal2;
}

/// The gradient of the signed distance to the facets.
Vec3 facet_normal(const Part& part, int t, Feature feature, const Vec3& pseudonormal, const Vec3& outward,
                  double distance_m) noexcept {
  if (feature == Feature::face || distance_m <= direction_resolution * part.size_m()) return pseudonormal;
  if (is_edge(feature) && is_flat_edge(part, t, edge_of(feature))) return pseudonormal;
  return outward / distance_m;
}

Vec3 interpolated_normal(const Part& part, int t, const Vec3& barycentric, const Vec3& otherwise) noexcept {
  const Vec3 sum = part.corner_normals.middleCols<3>(Eigen::Index{3} * t) * barycentric;
  const double length = sum.norm();
  // A fold between smooth neighbours can cancel the sum or turn it round; it says nothing then.
  if (!(length > 1e-6) || sum.dot(otherwise) <= 0) return otherwise;
  return sum / length;
}

/// No patch strays farther from its triangle than this: a tangent turns off its chord by at most 30 degrees.
double largest_bulge_m(const Part& part, Normals normals) noexcept {
  return normals == Normals::curved ? part.size_m() / 4 : 0;
}

/// The answer on the curved surface.
/// @param signed_distance_m  to the facets
SurfacePoint curved_surface_point(const CornerNormals& normals, const ClosestTriangle& facets, const Vec3& q,
                                  double signed_distance_m) noexcept {
  const Part& part = normals.part;
  const CurvedPoint found = closest_on_curved(normals, facets, q);
  const Feature feature = found.at.feature;
  const Vec3 pseudo = pseudonormal(part, found.triangle, feature);
  const bool smooth = is_smooth(part, found.triangle, feature);
  const Vec3 offset = q - found.at.point;
  const bool inside = std::abs(signed_distance_m) > found.deviation_m
                          ? signed_distance_m < 0
                          : offset.dot(smooth ? found.normal_P : pseudo) < 0;
  const double distance_m =
      std::isfinite(found.at.distance2_m2) ? std::sqrt(found.at.distance2_m2) : offset.stableNorm();
  SurfacePoint result;
  result.triangle = found.triangle;
  result.point_P = part.centre_P + found.at.point;
  result.pseudonormal_P = pseudo;
  result.signed_distance_m = inside ? -distance_m : distance_m;
  const Vec3 outward = inside ? Vec3(-offset) : offset;
  result.normal_P =
      smooth ? found.normal_P : facet_normal(part, found.triangle, feature, pseudo, outward, distance_m);
  return result;
}

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
  SurfacePoint result;
  const Vec3 q = p_P - part.centre_P;
  if (outside_padded_box(part, q, reach_m + largest_bulge_m(part, normals))) return result;
  // No bound on the search: what lies deep inside is answered whatever the reach.
  const ClosestTriangle found = tree.closest(q, hint, std::numeric_limits<double>::infinity());
  if (found.triangle < 0) return result;

  const int t = found.triangle;
  const Vec3 offset = q - found.at.point;
  const double distance_m =
      std::isfinite(found.at.distance2_m2) ? std::sqrt(found.at.distance2_m2) : offset.stableNorm();
  if (!std::isfinite(distance_m)) return result;  // no double can tell how far
  const Vec3 pseudo = pseudonormal(part, t, found.at.feature);
  const bool inside = offset.dot(pseudo) < 0;
  if (normals == Normals::curved) {
    const SurfacePoint curved =
        curved_surface_point({part, tree.curved_normals()}, found, q, inside ? -distance_m : distance_m);
    return curved.signed_distance_m <= reach_m ? curved : result;
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

}  // namespace

Vec3 shaded_normal(const TriangleTree& tree, int t, const TrianglePoint& at, Normals normals,
                   const Vec3& facet_normal_P) noexcept {
  const Part& part = tree.part();
  if (normals == Normals::facet || !is_smooth(part, t, at.feature)) return facet_normal_P;
  if (normals == Normals::smooth) return interpolated_normal(part, t, at.barycentric, facet_normal_P);
  return shown_normal(curved_patch({part, tree.curved_normals()}, t), at.barycentric, facet_normal_P);
}

SurfacePoint point_on_facet(const TriangleTree& tree, int t, const Vec3& p_P, Normals normals) noexcept {
  SurfacePoint result;
  if (normals == Normals::curved) return result;
  const Part& part = tree.part();
  const Vec3 q = p_P - part.centre_P;
  TriangleApproach foot = approach_triangle(part, t, q);
  if (is_edge(foot.at.feature)) {
    t = part.neighbours(edge_of(foot.at.feature), t);
    if (t < 0) return result;
    foot = approach_triangle(part, t, q);
  }
  if (foot.at.feature != Feature::face) return result;
  result.triangle = t;
  result.point_P = part.centre_P + foot.at.point;
  result.pseudonormal_P = part.facet_normals.col(t);
  result.normal_P = shaded_normal(tree, t, foot.at, normals, result.pseudonormal_P);
  result.signed_distance_m = result.pseudonormal_P.dot(q - foot.at.point);
  return result;
}

SurfacePoint nearest_surface_point(const TriangleTree& tree, const Vec3& p_P, Normals normals, int seed,
                                   double reach_m) noexcept {
  return nearest(tree, p_P, normals, seed, reach_m);
}

SurfacePoint nearest_surface_point(const TriangleTree& tree, const Vec3& p_P, Normals normals,
                                   ClosestMemory& memory, double reach_m) noexcept {
  return nearest(tree, p_P, normals, memory, reach_m);
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
