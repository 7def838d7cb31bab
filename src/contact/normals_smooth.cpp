#include "contact/normals.hpp"
#include "contact/normals_words.hpp"
#include "contact/part_measures.hpp"
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

/// Where half the largest turn over a smooth edge is more than the tilt that is allowed. Where the facets cut
/// in too deep as well, and no other normals can mend it, the reason says so.
std::string why_smooth(const NormalsDemand& demand) {
  if (demand.part.largest_smooth_turn_rad / 2 <= demand.tilt_rad) return {};
  if (demand.part.largest_sag_m <= demand.sag_m || demand.touches_own_surface) return turn_text(demand.part);
  return turn_text(demand.part) + "; " + sag_text(demand.part) +
         ", beyond the tolerance, and a proxy stands on them: use a finer mesh";
}

}  // namespace

/// Corner normals interpolated over the triangle.
constinit const NormalsEntry normals_smooth{"smooth", "corner normals interpolated over each facet",
                                            why_smooth, interpolated, nullptr};

}  // namespace fingerpad
