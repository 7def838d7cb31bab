#pragma once

#include "contact/closest_memory.hpp"
#include "contact/triangle_tree.hpp"

namespace fingerpad {

/// A point that walks round a part at one distance from it, with a heading.
struct SurfaceWalker {
  Vec3 p_P = Vec3::Zero();         ///< [m]
  Vec3 normal_P = Vec3::UnitZ();   ///< away from the part, unit
  Vec3 heading_P = Vec3::UnitX();  ///< across the normal, unit
  Vec3 foot_P = Vec3::Zero();      ///< the surface's point under it [m]
};

/// Walks at a signed distance from a part: the set of points at it is smooth round convex edges on the
/// outside, and has a fold in concave corners, over which the walker climbs.
class SurfaceWalk {
 public:
  /// @param distance_m  signed: below 0 inside of the part
  /// @param tolerance_m  of the distance, > 0
  SurfaceWalk(const TriangleTree& tree, double distance_m, double tolerance_m);

  /// Puts a walker over a point of triangle t. False where it cannot stand there: another wall is nearer.
  bool start(int t, const Vec3& surface_P, double heading_rad, SurfaceWalker& walker);
  /// Goes on by `step_m`, turning by `turn_rad` to the left on the way (seen from outside). False where that
  /// leads over an open rim, or nowhere.
  bool step(double step_m, double turn_rad, SurfaceWalker& walker);
  /// The signed distance of a point [m].
  double distance_at(const Vec3& p_P);

 private:
  bool settle(SurfaceWalker& walker);

  const TriangleTree& tree_;
  double distance_m_, tolerance_m_;
  int halts_ = 0;  // steps on end that came to nothing
  ClosestMemory memory_;
};

}  // namespace fingerpad
