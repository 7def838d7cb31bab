#include "contact/proxy_sweep.hpp"

#include <cmath>

#include "contact/proxy_limits.hpp"

namespace fingerpad {

TriangleSweep sweep_past_triangle(const TriangleCorners& f, const Vec3& from, const Vec3& to,
                                  double clearance_m, double tolerance_m) noexcept {
  const Vec3 way = to - from;
  TriangleSweep sweep;
  sweep.reached = 0;
  for (int k = 0; k < ProxyLimits::newton_steps; ++k) {
    const TriangleApproach here = approach_triangle(f, from + sweep.reached * way);
    const double gap_m = here.distance_m - clearance_m, slope = here.towards.dot(way);
    sweep.normal = here.towards;
    sweep.offset_m = here.towards.dot(here.at.point) + clearance_m;
    sweep.end_slack_m = gap_m + (1 - sweep.reached) * slope;
    if (sweep.end_slack_m >= -tolerance_m) {
      sweep.reached = 1;
      return sweep;
    }
    if (gap_m <= tolerance_m) break;
    sweep.reached += gap_m / -slope;
  }
  sweep.blocked = true;

  const Vec3 &normal = f.normal, corner = f.a;
  const double height_m = normal.dot(from - corner);
  if (std::abs(height_m) < clearance_m - tolerance_m) return sweep;
  // A triangle without area bears a neighbour's normal: it must lie in that plane.
  if (std::abs(normal.dot(f.b - f.a)) > tolerance_m || std::abs(normal.dot(f.c - f.a)) > tolerance_m)
    return sweep;
  const double side = height_m < 0 ? -1 : 1;
  const double slack_m = side * normal.dot(to - corner) - clearance_m;
  if (slack_m <= sweep.end_slack_m) return sweep;
  sweep.normal = side * normal;
  sweep.offset_m = side * normal.dot(corner) + clearance_m;
  sweep.end_slack_m = slack_m;
  sweep.blocked = slack_m < -tolerance_m;
  return sweep;
}

}  // namespace fingerpad
