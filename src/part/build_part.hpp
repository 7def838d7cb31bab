#pragma once

#include "part/load_progress.hpp"
#include "part/part.hpp"

namespace fingerpad {

/// What a repair did.
struct RepairCounts {
  long welded_vertices = 0;      ///< merged into others that lie near
  long turned_triangles = 0;     ///< to be wound as the rest of their piece
  long turned_bodies = 0;        ///< closed bodies turned outwards
  long turned_cavities = 0;      ///< closed shells inside a body turned inwards
  bool nesting_unknown = false;  ///< too many bodies overlap: each was turned outwards
};

/// What was seen while a part was built. Edges, components and winding count every triangle of the soup that
/// has three distinct vertices, before anything is left out; of a repaired part those that it is made of.
struct Census {
  long degenerate = 0;          ///< without area, to the rounding of the coordinates
  long duplicate = 0;           ///< same three welded vertices as an earlier triangle, in either winding
  long nonmanifold_edges = 0;   ///< with more than two triangles
  long boundary_edges = 0;      ///< with one
  long inconsistent_edges = 0;  ///< that two triangles pass in the same direction
  int components = 0;           ///< connected over welded vertices
  int inward_bodies = 0;        ///< closed, consistent bodies wound inwards, not inside another
  int outward_cavities = 0;     ///< closed, consistent bodies wound outwards, inside another
  bool inside_out = false;      ///< every body is closed and wound against its depth
  double volume_m3 = 0;         ///< signed, of the kept triangles
  double weld_distance_m = 0;
  bool closed = false;  ///< no boundary and no non-manifold edge
  RepairCounts repair;
};

/// A part with what was seen. The part has no triangle where none has an area.
struct BuiltPart {
  Part part;
  Census census;
};

/// make_part with its census. Left out are triangles with two corners welded into one, triangles that repeat
/// an earlier one, and triangles without area that no edge joins to one with area.
BuiltPart build_part(const TriangleSoup& soup, double crease_rad, const LoadProgress& progress = {});

/// As build_part, with what can be mended without a new triangle or a moved vertex: all vertices within 1e-7
/// of the diagonal are welded, and the winding is made right (repair.hpp). Boundary edges stay, and so do
/// triangles without area that join others: leaving them out would open the mesh.
BuiltPart build_repaired_part(const TriangleSoup& soup, double crease_rad, const LoadProgress& progress = {});

}  // namespace fingerpad
