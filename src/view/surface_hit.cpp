#include "view/surface_hit.hpp"

#include <algorithm>

#include "contact/triangle_tree.hpp"
#include "part/part.hpp"
#include "touch/world.hpp"

namespace fingerpad {
namespace {

std::optional<SurfaceHit> plane_hit(const Surface& plane, const Vec3& a_W, const Vec3& b_W) noexcept {
  const Vec3 way = b_W - a_W;
  const double fall = way.dot(plane.plane_normal_W);
  if (!(fall < 0)) return std::nullopt;  // seen from behind, or along
  SurfaceHit hit;
  hit.along = (plane.plane_point_W - a_W).dot(plane.plane_normal_W) / fall;
  if (!(hit.along >= 0 && hit.along <= 1)) return std::nullopt;
  hit.point_W = a_W + hit.along * way;
  hit.normal_W = plane.plane_normal_W;
  return hit;
}

/// The first facet on the way from a to b, whichever side of it is seen; relative to the part's centre.
SegmentHit first_facet(const TriangleTree& tree, const Vec3& a, const Vec3& b) noexcept {
  // Sheets as near to each other as this share of the way are taken for one.
  constexpr double same = 1e-9;
  SegmentHit first = tree.first_crossing(a, b);
  // The tree tells of facets seen from their front. One seen from its back is met by looking the other way,
  // the farthest first: what is found so comes nearer until none is left.
  for (double end = first.triangle < 0 ? 1 : first.along; end > same;) {
    const double start = end < 1 ? end - same : 1;
    const SegmentHit back = tree.first_crossing(a + start * (b - a), a);
    if (back.triangle < 0) break;
    first = {back.triangle, start * (1 - back.along)};
    end = std::min(first.along, end - same);  // nearer each time: a facet may lie on the line's very end
  }
  return first;
}

}  // namespace

std::optional<SurfaceHit> line_hit(const Surface& surface, const Vec3& a_W, const Vec3& b_W) noexcept {
  if (!surface.part) return plane_hit(surface, a_W, b_W);
  if (!surface.tree) return std::nullopt;
  const auto in_part = [&](const Vec3& p_W) -> Vec3 {
    return surface.R_WP.transpose() * (p_W - surface.p_WP) - surface.part->centre_P;
  };
  const SegmentHit facet = first_facet(*surface.tree, in_part(a_W), in_part(b_W));
  if (facet.triangle < 0) return std::nullopt;
  SurfaceHit hit;
  hit.along = facet.along;
  hit.point_W = a_W + facet.along * (b_W - a_W);
  hit.normal_W = surface.R_WP * surface.part->facet_normals.col(facet.triangle);
  return hit;
}

}  // namespace fingerpad
