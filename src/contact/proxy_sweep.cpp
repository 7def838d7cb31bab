#include "contact/proxy_sweep.hpp"

#include <cmath>

#include "contact/proxy_limits.hpp"

namespace fingerpad {

FacetSide facet_side(const TriangleCorners& f, const Vec3& from, const Vec3& to, double clearance_m,
                     double tolerance_m) noexcept {
  const Vec3& normal = f.normal;
  const double height_m = normal.dot(from - f.a);
  if (std::abs(height_m) < clearance_m - tolerance_m) return {};
  // A triangle without area bears a neighbour's normal: it must lie in that plane.
  if (std::abs(normal.dot(f.b - f.a)) > tolerance_m || std::abs(normal.dot(f.c - f.a)) > tolerance_m)
    return {};
  const double side = height_m < 0 ? -1 : 1;
  return {side, side * normal.dot(to - f.a) - clearance_m};
}

TriangleSweep sweep_past_triangle(const TriangleCorners& f, const Vec3& from, const Vec3& to,
                                  double clearance_m, double tolerance_m, const FirstApproach& first,
                                  double worst_m) noexcept {
  const Vec3 way = to - from;
  TriangleSweep sweep;
  sweep.free_share = 0;
  FirstApproach here = first;
  for (;;) {
    const double gap_m = here.distance_m - clearance_m, slope = here.towards.dot(way);
    sweep.end_slack_m = gap_m + (1 - sweep.free_share) * slope;
    if (sweep.end_slack_m >= -tolerance_m || sweep.end_slack_m > worst_m) {
      sweep.free_share = 1;
      return sweep;
    }
    if (gap_m <= tolerance_m) break;
    sweep.free_share += gap_m / -slope;
    if (++sweep.steps == ProxyLimits::newton_steps) break;
    here = FirstApproach(approach_triangle(f, from + sweep.free_share * way));
  }
  sweep.blocked = true;
  sweep.normal = here.towards;
  sweep.offset_m = here.towards.dot(here.foot) + clearance_m;

  const FacetSide facet = facet_side(f, from, to, clearance_m, tolerance_m);
  if (facet.side == 0 || facet.slack_m <= sweep.end_slack_m) return sweep;
  sweep.end_slack_m = facet.slack_m;
  sweep.blocked = facet.slack_m < -tolerance_m;
  const Vec3 facet_normal = facet.side * f.normal;
  // Over an edge the ball comes from behind the next facet's plane, which it is not to stay behind.
  if (facet_normal.dot(sweep.normal) < 0) return sweep;
  sweep.normal = facet_normal;
  sweep.offset_m = facet.side * f.normal.dot(f.a) + clearance_m;
  return sweep;
}

}  // namespace fingerpad
