#pragma once

#include <vector>

#include "part/build_part.hpp"
#include "part/edge_table.hpp"

namespace fingerpad {

/// Points and triangles with unused points gone and the centre taken out.
struct Centred {
  Vec3 centre_P = Vec3::Zero(), half_extent = Vec3::Zero();
  double largest_coordinate = 0;  // in frame P
  Points points;
  IndexTriples triangles;
};

/// Those of a soup's triangles that are kept.
Centred centred(const TriangleSoup& soup, const std::vector<int>& kept);

/// Who is connected with whom.
struct Connected {
  IndexTriples welded;
  int welded_count = 0;
  EdgeTable edges;
  EdgeCounts counts;
  double weld_distance = 0;
};

/// Welds equal vertices; where that leaves boundary edges, those on them also at 1e-7 of the diagonal. The
/// second is kept only where it closes the mesh and neither collapses a triangle nor makes an edge
/// non-manifold.
Connected weld(const Centred& mesh);

/// Welds all vertices within 1e-7 of the diagonal, whatever comes of it.
Connected weld_all(const Centred& mesh, RepairCounts& counts);

}  // namespace fingerpad
