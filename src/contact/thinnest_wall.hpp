#pragma once

#include "contact/triangle_tree.hpp"

namespace fingerpad {

/// The thinnest wall of a closed part [m]: the shortest way, among sampled points, from a facet straight
/// inwards to where the ray leaves the part again through a facet that faces the first within 30 degrees. A
/// sharp edge is no wall: facets that share a vertex with the first are not looked at, and a ray that leaves
/// through a slanted facet does not count.
///
/// Samples: every facet is cut into m x m like parts and a ray starts from the centre of each, m the largest
/// of 1 .. 8 that keeps the rays under 200,000; a mesh with more facets than that sends one ray from every
/// k-th facet. (Fewer rays are sent where affordable_rays says so: through needles that fan out by
/// thousands.) So a wall thinner than its surroundings over less than a sample's width can be missed; the
/// same part gives the same answer.
///
/// Not a number for an open part; infinite where no wall was met (a tetrahedron).
/// @param part  the part that `tree` was built on
double thinnest_wall_m(const Part& part, const TriangleTree& tree);

}  // namespace fingerpad
