#pragma once

#include <limits>
#include <vector>

#include "contact/surface_places.hpp"

namespace fingerpad {

struct Part;
class TriangleTree;

/// What of a part's shape decides how it can be touched: its edges, all of them, and its walls, at samples.
/// Lengths in metres, angles as turns of the facets' normals: 0 where two facets lie in one plane, pi where
/// one folds back onto the other.
///
/// A turn is only believed where both facets are higher over the edge than a hundred roundings of the file's
/// float32 coordinates: the normals of thinner slivers are noise.
struct PartMeasures {
  long open_edges = 0;  ///< half-edges with no single neighbour: at a boundary, or where more than two meet
  long contradicting_edges = 0;  ///< half-edges whose neighbour is wound the other way
  double volume_m3 = 0;          ///< signed: < 0 where the part is inside out; means nothing where it is open

  double sharpest_ridge_rad = 0;   ///< largest turn across a convex edge; pi less the angle of the material
  double sharpest_edge_rad = 0;    ///< largest turn across a convex edge that is a crease
  double sharpest_valley_rad = 0;  ///< largest turn across a concave edge that is a crease
  double tightest_hollow_m = inf;  ///< smallest radius of the surface across concave edges that are no crease
  double largest_smooth_turn_rad = 0;  ///< across an edge that is no crease
  double largest_sag_m = 0;  ///< of facets that stand for a smooth surface: how far they cut into it

  double thinnest_wall_m = inf;  ///< the shortest way through a wall: the number that people are told
  double thinnest_m = inf;       ///< the smallest local thickness met: sides that lean count too
  double median_m = inf;         ///< half of the surface's area is thinner
  int ray_count = 0;
  int overlap_count = 0;  ///< samples whose ray enters another sheet before, or where, it leaves its own:
                          ///< there bodies overlap, or a surface passes through itself

  std::vector<SurfacePlace> places;  ///< how well the facets stand for a smooth surface, all over the part
  double tightest_round_m = inf;     ///< all but a hundredth of its area is rounded less tightly, to a fifth
  double median_round_m = inf;       ///< and half of it

  // Of a part that stands far off its file's origin (is_far_off); near it both are 0.
  double rounding_m = 0;    ///< of the file's float32 coordinates, at the most: of a vertex's place
  double untold_share = 0;  ///< of a region's area, at the most: facets whose normals are not believed

  static constexpr double inf = std::numeric_limits<double>::infinity();
};

/// Measures a part on all threads. Bounded: every edge is looked at once, and at most 60,000 rays are cast;
/// the same part gives the same answer on any number of threads.
///
/// A wall: a ray goes from a facet straight inwards to where it leaves the part, and there the facet faces
/// the first within 30 degrees; the wall is as thick as the ray is long. A sharp edge is no wall: facets that
/// share a vertex with the first are not looked at, and a ray that leaves through a slanted facet does not
/// count. A wall thinner than its surroundings over less than a sample's width can be missed.
///
/// Local thickness: a ray goes from a facet straight inwards to where it leaves the part, through a facet
/// whose normal is turned by at least 120 degrees (others are no opposite side); it is the diameter of the
/// ball that touches both facets' planes, the first where the ray starts: L (1 - tan^2(a/2)) for a ray of
/// length L and facets that meet at the angle a; L for parallel ones.
///
/// Rays start from the centres of every facet's m x m like parts, m the largest of 1 .. 8 that keeps them
/// under 60,000; a mesh with more facets sends one from every k-th facet, then 40,000 at most. (Fewer where
/// affordable_rays says so: through needles that fan out by thousands.)
///
/// Overlap: between a facet and where a ray straight inwards first leaves, a solid has no other facet. One
/// met from the outside means that two bodies, or two sheets of one, take the same room (the way back must
/// meet no facet from the outside: none was left before). Looked for along 10,000 of the rays at most, from
/// facets whose normal is believed; so what overlaps over less than the samples' distance can be missed.
/// Bodies that touch over an area count: their common wall is no surface.
/// @param part  the part that `tree` was built on
PartMeasures measure_part(const Part& part, const TriangleTree& tree);

/// PartMeasures::thinnest_wall_m as it is told of a mesh: infinite where no wall was met (a tetrahedron), not
/// a number for an open part, which has no inside.
double told_wall_m(const Part& part, const PartMeasures& measures) noexcept;

/// Facets whose normals turn by at least this face opposite ways: two thirds of a half turn.
inline constexpr double opposite_turn_rad = 2.0943951023931953;

}  // namespace fingerpad
