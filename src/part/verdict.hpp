#pragma once

#include <string>
#include <vector>

#include "part/bounds.hpp"

namespace fingerpad {

/// What can be said about a mesh, good and bad. Counts are of all that the file holds, before anything was
/// left out; where it was repaired, edges, components, winding and volume are the repaired part's.
struct Verdict {
  std::string file;    ///< as it was named by the caller
  std::string format;  ///< "binary STL", "text PLY", ...; empty where that could not be told
  bool touchable = false;
  std::string error;                  ///< why not, with the place in the file; empty where touchable
  std::vector<std::string> warnings;  ///< each names a damage and what it means for touch
  long vertices = 0;                  ///< in the file (of an STL: three a triangle)
  long triangles = 0;                 ///< read (polygons fanned)
  long kept = 0;                      ///< in the part
  long out_of_range = 0;        ///< triangles left out because their face names a vertex that is not there
  long degenerate = 0;          ///< zero area
  long duplicate = 0;           ///< same three welded vertices as an earlier triangle, either winding
  long nonmanifold_edges = 0;   ///< with more than two triangles
  long boundary_edges = 0;      ///< with one
  long inconsistent_edges = 0;  ///< that two triangles pass in the same direction
  int components = 0;           ///< connected over welded vertices
  bool winding_consistent = false;  ///< no two triangles pass an edge in the same direction
  bool closed = false;              ///< no boundary, every edge manifold
  double volume_m3 = 0;             ///< signed: negative where the normals point inwards
  Bounds bounds_m;                  ///< frame P
  bool repaired = false;       ///< it was asked for; what was done are the first warnings, "repaired: ..."
  double weld_distance_m = 0;  ///< vertices closer than this were taken as one; 0: only equal ones
  double rounding_m = 0;       ///< the farthest a vertex was moved by rounding to float32
  double resolution_m =
      0;  ///< the step of the file's coordinates at the part's place, where they are float32
};

/// The verdict in a few lines for a person; ends with a newline.
std::string verdict_text(const Verdict& verdict);

/// Why a mesh cannot be touched, as "FILE: PLACE: WHAT", on one line.
std::string refusal_text(const Verdict& verdict);

}  // namespace fingerpad
