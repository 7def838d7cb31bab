#pragma once

#include <string>
#include <vector>

#include "part/part.hpp"

namespace fingerpad {

/// What can be said about a mesh, good and bad. Counts are after the file was read, before anything was left
/// out.
struct Verdict {
  std::string file;
  bool touchable = false;
  std::string error;                  ///< why not, empty where touchable
  std::vector<std::string> warnings;  ///< each names a damage and what it means for touch
  long triangles = 0;                 ///< read (polygons fanned)
  long kept = 0;                      ///< in the part
  long degenerate = 0;                ///< zero area
  long duplicate = 0;                 ///< same three welded vertices as an earlier triangle, either winding
  long nonmanifold_edges = 0;         ///< with more than two triangles
  long boundary_edges = 0;            ///< with one
  int components = 0;                 ///< connected over welded vertices' edges
  bool winding_consistent = false;    ///< no two triangles pass an edge in the same direction
  bool closed = false;                ///< no boundary, every edge manifold
  double volume_m3 = 0;               ///< signed: negative where the normals point inwards
  Bounds bounds_m;                    ///< frame P
};

}  // namespace fingerpad
