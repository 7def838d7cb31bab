#include <cmath>

#include "contact/curved_closest.hpp"
#include "contact/facet_rule.hpp"
#include "contact/normals.hpp"
#include "contact/surface_places.hpp"
#include "contact/surface_point.hpp"

namespace fingerpad {
namespace {

Vec3 shown(const TriangleTree& tree, int t, const TrianglePoint& at, const Vec3& facet_normal_P) noexcept {
  return shown_normal(curved_patch({tree.part(), tree.curved_normals()}, t), at.barycentric, facet_normal_P);
}

SurfacePoint on_patch(const TriangleTree& tree, const ClosestTriangle& facets, const Vec3& q,
                      double signed_distance_m) noexcept {
  const Part& part = tree.part();
  const CurvedPoint found = closest_on_curved({part, tree.curved_normals()}, facets, q);
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

}  // namespace

/// A cubic patch over each triangle (curved_patch.hpp) stands for the surface: point, distance and normal are
/// the patch's. The point's error falls with the cube of the facet size, the normal's with its square.
/// No patch strays farther from its triangle than a quarter of the part: a tangent turns off its chord by at
/// most 30 degrees.
constinit const NormalsEntry normals_curved{
    .name = "curved",
    .summary =
        "a cubic patch over each facet is touched (a proxy stands on the facets: there it only shades)",
    .off_rad = curved_off_rad,
    .shade = shown,
    .own_surface = on_patch,
    .strays = 0.25,
    .prepare = [](const TriangleTree& tree) { tree.prepare_curved(); }};

}  // namespace fingerpad
