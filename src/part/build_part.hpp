#pragma once

#include "part/part.hpp"

namespace fingerpad {

/// What was seen while a part was built. Edges, components and winding count every triangle of the soup that
/// has three distinct vertices, before anything is left out.
struct Census {
  long degenerate = 0;          ///< without area, to the rounding of the coordinates
  long duplicate = 0;           ///< same three welded vertices as an earlier triangle, in either winding
  long nonmanifold_edges = 0;   ///< with more than two triangles
  long boundary_edges = 0;      ///< with one
  long inconsistent_edges = 0;  ///< that two triangles pass in the same direction
  int components = 0;           ///< connected over welded vertices
  int inward_bodies = 0;        ///< closed, consistent bodies wound inwards, not inside another
  double volume_m3 = 0;         ///< signed, of the kept triangles
  double weld_distance_m = 0;
  bool closed = false;  ///< no boundary and no non-manifold edge
};

/// A part with what was seen. The part has no triangle where none has an area.
struct BuiltPart {
  Part part;
  Census census;
};

/// make_part with its census. Left out are triangles with two corners welded into one, triangles that repeat
/// an earlier one, and triangles without area that no edge joins to one with area.
BuiltPart build_part(const TriangleSoup& soup, double crease_rad);

}  // namespace fingerpad
