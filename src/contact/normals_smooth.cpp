#include "contact/normals.hpp"
#include "contact/surface_places.hpp"
#include "contact/triangle_tree.hpp"

namespace fingerpad {
namespace {

Vec3 interpolated(const TriangleTree& tree, int t, const TrianglePoint& at,
                  const Vec3& facet_normal_P) noexcept {
  const Vec3 sum = tree.part().corner_normals.middleCols<3>(Eigen::Index{3} * t) * at.barycentric;
  const double length = sum.norm();
  // A fold between smooth neighbours can cancel the sum or turn it round; it says nothing then.
  if (!(length > 1e-6) || sum.dot(facet_normal_P) <= 0) return facet_normal_P;
  return sum / length;
}

double smooth_off_rad(const SurfacePlace& place) noexcept {
  return place.smooth_rad + off_with_curved_rad(place);
}

}  // namespace

/// Corner normals interpolated over the triangle.
constinit const NormalsEntry normals_smooth{.name = "smooth",
                                            .summary = "corner normals interpolated over each facet",
                                            .off_rad = smooth_off_rad,
                                            .shade = interpolated};

}  // namespace fingerpad
