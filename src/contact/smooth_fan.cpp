#include "contact/smooth_fan.hpp"

#include <Eigen/Geometry>

#include "contact/facet_rule.hpp"

namespace fingerpad {
namespace {

enum class Around { cut_short, to_both_ends, closed };

/// Takes every corner of the fan but `at`, first one way around and, where that ends, the other, until `take`
/// is false, which cuts it short.
template <typename Take>
Around each_other(const Part& part, PartCorner at, const Take& take) noexcept {
  for (const int edge : {at.corner, (at.corner + 2) % 3}) {
    VertexTurn turn{part.welded(at.corner, at.triangle), at.triangle, edge};
    while (turn.next(part) >= 0 && !has_crease(part, turn.triangle, turn.edge)) {
      if (turn.next(part) == at.triangle) return Around::closed;
      turn.go_on(part);
      if (!take(PartCorner{turn.triangle, turn.corner(part)})) return Around::cut_short;
    }
  }
  return Around::to_both_ends;
}

FanFacet fan_facet(const Part& part, PartCorner at) noexcept {
  const auto [t, corner] = at;
  const Vec3 p = part.vertices.col(part.triangles(corner, t));
  FanFacet facet{at, part.facet_normals.col(t), part.vertices.col(part.triangles((corner + 1) % 3, t)) - p,
                 part.vertices.col(part.triangles((corner + 2) % 3, t)) - p};
  facet.doubled_area_m2 = facet.first.cross(facet.second).norm();
  if (!(facet.doubled_area_m2 > 0)) facet.normal.setZero();
  return facet;
}

}  // namespace

std::optional<PartCorner> SmoothFan::lowest(const Part& part, PartCorner at) noexcept {
  PartCorner lowest = at;
  std::size_t others = 0;
  const Around around = each_other(part, at, [&](PartCorner other) {
    if (other.column() < lowest.column()) lowest = other;
    return ++others < most_facets;
  });
  return around != Around::cut_short ? std::optional(lowest) : std::nullopt;
}

bool SmoothFan::gather(const Part& part, PartCorner lowest) noexcept {
  count_ = 0;
  facets_[count_++] = fan_facet(part, lowest);
  const Around around = each_other(part, lowest, [&](PartCorner other) {
    if (count_ == most_facets || other.column() < lowest.column()) return false;
    facets_[count_++] = fan_facet(part, other);
    return true;
  });
  is_closed_ = around == Around::closed;
  return around != Around::cut_short;
}

}  // namespace fingerpad
