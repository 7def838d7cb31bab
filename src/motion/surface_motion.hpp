#pragma once

#include <cstdint>

#include "motion/motion.hpp"

namespace fingerpad {

class TriangleTree;

/// A rub that is laid on a part: a figure drawn in the surface at a random place, along which the finger is
/// pressed in. The figure has its own lengths and bends in the surface, as if drawn on paper that clings to
/// it.
struct SurfaceMotion {
  enum class Shape {
    line,    ///< to and fro, of length size_m
    circle,  ///< of radius size_m
    spiral   ///< from the place outwards to radius size_m, its turns evenly apart (Archimedes)
  };
  Shape shape = Shape::line;
  std::int64_t place = 1;  ///< which of the random places, each with its direction: the seed of both
  double size_m = 0.01;    ///< see Shape
  double turns = 1;        ///< of the circle and the spiral; strokes of the line
  double speed_m_per_s = 0.1;
  double depth_m = 0;         ///< how deep it is pressed in, 0: as normal_force_n says
  double normal_force_n = 0;  ///< over the part's stiffness: the depth
};

/// How long it takes, the way down to the surface and up again with it [s]; without the ways round sharp
/// edges, see lay_on_surface().
double duration_s(const SurfaceMotion& rub, double depth_m) noexcept;

/// A motion in the part's frame, and how many places were tried until one held it.
struct LaidMotion {
  Motion motion;
  Vec3 place_P = Vec3::Zero();  ///< where the surface is touched first [m]
  int tried = 0;
  int edges = 0;  ///< sharp ones round which the finger is taken, in a stroke of a line, else in all
};

/// Lays a rub on a part. The finger's centre keeps the distance radius_m - depth_m from the whole surface, at
/// an even speed, so that it rolls over edges and turns in corners without being pressed in any deeper; it
/// comes from outside along the normal, and leaves so.
///
/// A finger pressed in deeper than its radius has its centre inside, where that distance has no way round a
/// convex edge. At a sharp one it eases off to the edge, goes round it and comes in again beyond
/// (way_round_edge), which takes longer than duration_s(), so that no proxy is left behind on the first face.
/// A finger pressed in deeper than half its radius is tried: at no tick is a proxy with the facets' normals
/// pressed in by over 1.1 times the depth.
///
/// A place where it would be, where it would leave the part over an open rim, where the finger has no room or
/// the wall is too thin for the depth is given up for the next of the stream. Depends on the part, the rub,
/// radius, depth and rate alone.
/// @param rate_hz  of the ticks that will feel it
/// Throws Error (refused) without a place where no place holds it.
LaidMotion lay_on_surface(const TriangleTree& tree, const SurfaceMotion& rub, double radius_m, double depth_m,
                          double rate_hz = 1000);

}  // namespace fingerpad
