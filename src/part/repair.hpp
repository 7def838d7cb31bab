#pragma once

#include <vector>

#include "part/bodies.hpp"
#include "part/build_part.hpp"
#include "part/edge_table.hpp"

namespace fingerpad {

/// Which triangles must be turned so that each piece of the mesh (connected over edges of two triangles) is
/// wound in one way: the fewer of each piece, or those of the other way than its lowest triangle where both
/// are as many. A piece with one side only (a Moebius band) keeps edges that clash.
std::vector<bool> turns_to_one_way(const EdgeTable& edges, const IndexTriples& corners);

/// Turns triangles round: corners 1 and 2 change places.
void turn(IndexTriples& corners, const std::vector<bool>& turned);

/// Winds a mesh: each piece in one way, then closed bodies by their depth, outer ones outwards and cavities
/// inwards. Closes nothing and leaves nothing out.
/// @param triangles  turned in step with `welded`
/// @param counts     what was done is added
/// @returns          the edges of the result
EdgeTable wind(const Points& vertices, IndexTriples& triangles, IndexTriples& welded, int welded_count,
               EdgeTable edges, RepairCounts& counts);

}  // namespace fingerpad
