#include "motion/sharp_edge.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace fingerpad {
namespace {

/// A proxy that lags at this turn presses 1/cos = 1.06 times as deep, which nobody feels.
constexpr double sharp_turn_rad = 20 * std::numbers::pi / 180;

/// Of the face that is nearest to a walker inside, outward. A step's normal is that of the wall which it
/// meets, and near a fold the walker may stand nearer to the other still.
Vec3 face_normal(const SurfaceWalker& walker) {
  return (walker.foot_P - walker.p_P).normalized();
}

/// Where the two faces' planes meet, at the place that is nearest to the fold.
struct EdgePlace {
  Vec3 apex_P, outwards_P;  ///< the second unit, away from the fold
  double way_m = 0;         ///< from the fold
};

EdgePlace edge_between(const SurfaceWalker& before, const SurfaceWalker& after) {
  const Vec3 fold_P = (before.p_P + after.p_P) / 2;
  const Vec3 first = face_normal(before), second = face_normal(after);
  const double c = first.dot(second);
  const double to_first_m = first.dot(before.foot_P - fold_P);
  const double to_second_m = second.dot(after.foot_P - fold_P);
  const Vec3 way =
      ((to_first_m - c * to_second_m) * first + (to_second_m - c * to_first_m) * second) / (1 - c * c);
  return {fold_P + way, way.normalized(), way.norm()};
}

/// Outside of a face, close to the edge: `clearance_m` above it, and as far back from the edge.
Vec3 beside_edge(const Vec3& apex_P, const SurfaceWalker& walker, double clearance_m) {
  const Vec3 to_foot = walker.foot_P - apex_P;
  const Vec3 normal = face_normal(walker);
  const Vec3 back = (to_foot - normal.dot(to_foot) * normal).normalized();
  return apex_P + clearance_m * (normal + back);
}

/// Adds the points of a straight way, without its begin, with its end.
void go_straight(const Vec3& to_P, double step_m, const Vec3& from_P, std::vector<Vec3>& way) {
  const auto steps = std::max(1L, std::lround(std::ceil((to_P - from_P).norm() / step_m)));
  for (long k = 1; k <= steps; ++k)
    way.emplace_back(from_P + (to_P - from_P) * (static_cast<double>(k) / static_cast<double>(steps)));
}

}  // namespace

bool turns_sharp_edge(const SurfaceWalker& before, const SurfaceWalker& after) {
  const Vec3 first = face_normal(before), second = face_normal(after);
  const double turn_rad = std::atan2(first.cross(second).norm(), first.dot(second));
  // Over a fold the foot leaps from face to face, by a chord that is turned by half as much as they are; in a
  // concave corner it stays.
  constexpr double least_fall = 0.1;
  const Vec3 leap = after.foot_P - before.foot_P;
  const bool is_convex = leap.dot(first) < -least_fall * leap.norm();
  return turn_rad > sharp_turn_rad && is_convex;
}

std::vector<Vec3> way_round_edge(const SurfaceWalker& before, const SurfaceWalker& after, double step_m,
                                 double clearance_m) {
  constexpr double most_depths = 50;  // a blade of 2 degrees
  const EdgePlace edge = edge_between(before, after);
  const double depth_m = (before.p_P - before.foot_P).norm();
  std::vector<Vec3> way;
  if (!(edge.way_m <= most_depths * depth_m)) return way;
  const Vec3 stops[] = {beside_edge(edge.apex_P, before, clearance_m),
                        edge.apex_P + 2 * clearance_m * edge.outwards_P,
                        beside_edge(edge.apex_P, after, clearance_m), after.p_P};
  Vec3 from_P = before.p_P;
  for (const Vec3& stop : stops) {
    go_straight(stop, step_m, from_P, way);
    from_P = stop;
  }
  way.pop_back();
  return way;
}

}  // namespace fingerpad
